// SPDX-License-Identifier: GPL-3.0-or-later
// The quick reader against its naive twin: it leaves a token alone, or agrees exactly.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cfenv>
#include <cstdlib>
#include <string>
#include <vector>

#include "kernels/number/parse.hpp"

namespace fathom::kernels {
namespace {

[[maybe_unused]] const int configured = setenv("RC_PARAMS", "seed=34 max_success=20000", 0);

/// Whether the quick reader took the token; if so it must agree.
bool quick(const std::string& token, Decimals decimals) {
  const std::optional<double> value = quick_number(token, decimals);
  if (!value) return false;
  const ParsedNumber naive = parse_number(token, decimals);
  EXPECT_TRUE(naive.value.has_value()) << token;
  EXPECT_EQ(mpq_class(*value), naive.value.value_or(mpq_class(-54321))) << token;
  return true;
}

TEST(QuickNumber, TakesWhatMeshesHold) {
  for (const char* token : {"0", "-0", "007", "9007199254740992", "-9007199254740992"}) {
    EXPECT_TRUE(quick(token, Decimals::binary64)) << token;
    EXPECT_TRUE(quick(token, Decimals::exact)) << token;
  }
  for (const char* token : {"0.1", "-.5", "1.", "1e5", "1.25E-7", "0.30000000000000004", "9007199254740993.0", "2.2250738585072012e-308",
                            "1.7976931348623157e308", "4.9406564584124654e-324"}) {
    EXPECT_TRUE(quick(token, Decimals::binary64)) << token;
    EXPECT_FALSE(quick(token, Decimals::exact)) << token;
  }
}

TEST(QuickNumber, LeavesTheRest) {
  for (const char* token : {"",
                            "+1",
                            "-",
                            ".",
                            "inf",
                            "-inf",
                            "nan",
                            "infinity",
                            "1e400",
                            "-1e400",
                            "1e-400",
                            "0x1p3",
                            "0x1.8",
                            "1/2",
                            "1e",
                            "1e+",
                            "1 ",
                            " 1",
                            "1,5",
                            "9007199254740993",
                            "-9007199254740993",
                            "1.5f",
                            "--1",
                            "nan(e1)"}) {
    EXPECT_FALSE(quick(token, Decimals::binary64)) << token;
    EXPECT_FALSE(quick(token, Decimals::exact)) << token;
  }
  EXPECT_FALSE(quick(std::string(65, '1'), Decimals::binary64));
  EXPECT_FALSE(quick("1." + std::string(2'000'000, '0'), Decimals::binary64)) << "which parse_number refuses";
}

TEST(QuickNumber, AgreesOnWhateverIsWritten) {
  const std::vector<std::string> pieces{
      "0", "1", "9",   "5",   "17976931348623157", "99999999999", ".", "-", "+", "e", "E", "e-", "e3", "308", "/",
      "x", "p", "inf", "nan", "49406564584124654"};
  EXPECT_TRUE(rc::check([&] {
    std::string token;
    for (const std::string& piece : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(pieces))) token += piece;
    quick(token, Decimals::binary64);
    quick(token, Decimals::exact);
  }));
  EXPECT_TRUE(rc::check([&] {
    const auto digits = *rc::gen::container<std::string>(rc::gen::inRange<char>('0', '9' + 1));
    const int exponent = *rc::gen::inRange(-330, 315);
    quick("0." + digits + "e" + std::to_string(exponent), Decimals::binary64);
    quick(digits, Decimals::binary64);
  }));
}

TEST(QuickNumber, LeavesDecimalsWhileRoundingIsNotToNearest) {
  std::fesetround(FE_UPWARD);
  const bool decimal = quick_number("0.1", Decimals::binary64).has_value(), integer = quick_number("12", Decimals::binary64).has_value();
  std::fesetround(FE_TONEAREST);
  EXPECT_FALSE(decimal);
  EXPECT_TRUE(integer);
}

}  // namespace
}  // namespace fathom::kernels
