// SPDX-License-Identifier: GPL-3.0-or-later
// Exact parsing against two twins: a regular expression with schoolbook evaluation for what is a
// number and which one, and the standard library's readers of doubles for what the nearest binary64
// is.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <bit>
#include <cfenv>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <locale>
#include <optional>
#include <random>
#include <regex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/text.hpp"
#include "tests/support/full_size.hpp"
#include "tests/support/property.hpp"
#include "tests/support/words.hpp"

namespace fathom::kernels {
namespace {

using testing::random_in;
using testing::random_word;

mpq_class exact(std::string_view token) {
  const ParsedNumber parsed = parse_number(token, Decimals::exact);
  EXPECT_TRUE(parsed.value.has_value()) << token.substr(0, 100) << ": " << parsed.error;
  return parsed.value.value_or(mpq_class(-12345));
}

double random_double() {
  const double x = std::bit_cast<double>(random_word());
  return std::isfinite(x) ? x : 1.0 / 3.0;
}

mpz_class power(unsigned long base, long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, static_cast<unsigned long>(exponent));
  return result;
}

/// The full decimal expansion of a number whose denominator is a power of two.
std::string expansion(const mpq_class& x) {
  const long places = static_cast<long>(mpz_scan1(x.get_den_mpz_t(), 0));
  std::string digits = mpz_class(abs(x.get_num()) * power(5, places)).get_str();
  if (static_cast<long>(digits.size()) <= places)
    digits.insert(0, static_cast<std::size_t>(places) + 1 - digits.size(), '0');
  digits.insert(digits.size() - static_cast<std::size_t>(places), 1, '.');
  return (sgn(x) < 0 ? "-" : "") + digits;
}

TEST(ParseNumber, EveryNotationExactly) {
  // clang-format off
  const std::pair<const char*, mpq_class> table[] = {
      {"0", 0}, {"-0", 0}, {"+7", 7}, {"-7", -7}, {"007", 7}, {"010", 10},
      {"12345678901234567890123", mpq_class("12345678901234567890123")},
      {"22/7", {22, 7}}, {"-6/4", {-3, 2}}, {"+4/2", 2}, {"0/5", 0}, {"08/010", {4, 5}},
      {"0.1", {1, 10}}, {".5", {1, 2}}, {"5.", 5}, {"-1.50", {-3, 2}}, {"00.25", {1, 4}}, {"0.0", 0}, {"-0.0", 0}, {"-.0e7", 0},
      {"1e3", 1000}, {"1E+3", 1000}, {"1e-3", {1, 1000}}, {"25e-1", {5, 2}}, {"1.25e2", 125}, {"1.e1", 10}, {".1e1", 1}, {"1e0003", 1000},
      {"100e-2", 1}, {"0e0", 0}, {"0e-100000", 0},
      {"0x10", 16}, {"0XfF", 255}, {"0xAbCdEf9", 180150009}, {"0x1.8p-3", {3, 16}}, {"-0x1.8P+3", -12}, {"0x.8", {1, 2}}, {"0x8.", 8},
      {"0x0p0", 0}, {"-0x0.0p-7", 0},
      {"0x1p-2", {1, 4}}, {"0x1.999999999999ap-4", exact_value(0.1)}, {"0x0.8p1", 1}, {"0xep1", 28}, {"0x100p-8", 1}};
  // clang-format on
  for (const auto& [token, value] : table) {
    EXPECT_EQ(exact(token), value) << token;
    EXPECT_EQ(exact_text(exact(token)), exact_text(value)) << token << ": lowest terms";
  }
  EXPECT_EQ(exact("1e100000"), mpq_class(power(10, 100000)));
  EXPECT_EQ(exact("-1e-100000"), mpq_class(-1, power(10, 100000)));
  EXPECT_EQ(exact("0x1p400000"), mpq_class(power(2, 400000)));
  EXPECT_EQ(exact("0x1p-400000"), mpq_class(1, power(2, 400000)));
}

TEST(ParseNumber, Binary64MeansTheNearestForDecimalsOnly) {
  // clang-format off
  const std::pair<const char*, mpq_class> table[] = {
      {"0.1", exact_value(0.1)}, {"-0.1", exact_value(-0.1)}, {"1e23", exact_value(1e23)}, {"1E-400", 0}, {"-1e-400", 0}, {"0.5", {1, 2}},
      {"9007199254740993.0", mpq_class("9007199254740992")}, {"9007199254740993e0", mpq_class("9007199254740992")},
      {"9007199254740993", mpq_class("9007199254740993")},  // an integer is exact
      {"1/10", {1, 10}}, {"0x1.00000000000001p0", mpq_class(power(2, 56) + 1, power(2, 56))},
      {"1.7976931348623158e308", exact_value(std::numeric_limits<double>::max())}, {"4.9e-324", exact_value(5e-324)},
      {"2.4703282292062327e-324", 0}, {"2.4703282292062328e-324", exact_value(5e-324)}, {"0e999999999999999999999999", 0},
      {"1e-999999999999999999999999", 0}, {"0.0e-100001", 0}};
  // clang-format on
  for (const auto& [token, value] : table) {
    const ParsedNumber parsed = parse_number(token, Decimals::binary64);
    ASSERT_TRUE(parsed.value.has_value()) << token << parsed.error;
    EXPECT_EQ(*parsed.value, value) << token;
    EXPECT_EQ(parsed.error, "");
  }
  for (const char* token : {"1e400", "-1e400", "1.7976931348623159e308", "1e999999999999999999999999", "1e309"}) {
    const ParsedNumber parsed = parse_number(token, Decimals::binary64);
    EXPECT_FALSE(parsed.value.has_value()) << token;
    EXPECT_EQ(parsed.error, "expected a number, found '" + std::string(token) + "': beyond binary64");
  }
}

TEST(ParseNumber, EachBadTokenHasItsReason) {
  // clang-format off
  const std::pair<std::string, const char*> table[] = {
      {"nan", "not finite"}, {"-NaN", "not finite"}, {"nan(1)", "not finite"}, {"inf", "not finite"}, {"-Infinity", "not finite"},
      {"+", "no digits"}, {"-", "no digits"}, {".", "no digits"}, {"-.", "no digits"}, {"--1", "more than one sign"},
      {"+-1", "more than one sign"}, {"0x", "no digits after '0x'"}, {"0x.", "no digits after '0x'"}, {"0x.p1", "unexpected 'p'"},
      {"0x1p", "no digits in the exponent after 'p'"}, {"0x1P+", "no digits in the exponent after 'P'"},
      {"0x1pf", "no digits in the exponent"},
      {"0xg", "unexpected 'g'"}, {"0x-1", "unexpected '-'"}, {"1e", "no digits in the exponent after 'e'"},
      {"1E-", "no digits in the exponent after 'E'"}, {"1e+-2", "no digits in the exponent"}, {"e5", "unexpected 'e'"},
      {".e5", "unexpected 'e'"},
      {"1e5.0", "unexpected '.'"}, {"1.2.3", "unexpected '.'"}, {"1,5", "unexpected ','"},
      {"1 ", "unexpected ' '"}, {" 1", "unexpected ' '"},
      {"1_000", "unexpected '_'"}, {"1d5", "unexpected 'd'"}, {"1f", "unexpected 'f'"}, {"12abc", "unexpected 'a'"},
      {"\t1", "unexpected '\\x09'"},
      {std::string("1\0", 2), "unexpected '\\x00'"}, {"\xe2\x88\x92" "1", "unexpected '\\xe2'"}, {"1/0", "the denominator is zero"},
      {"0/0", "the denominator is zero"}, {"1/-2", "expected digits only after '/'"}, {"1/", "expected digits only after '/'"},
      {"/2", "expected digits only before '/'"}, {"1/2/3", "expected digits only after '/'"}, {"1.5/2", "expected digits only before '/'"},
      {"1/2e3", "expected digits only after '/'"}, {"0x1/2", "unexpected '/'"}, {"1e100001", "the decimal exponent is beyond 100000"},
      {"1.5e-100001", "the decimal exponent is beyond 100000"}, {"1e99999999999999999999999999", "the decimal exponent is beyond 100000"},
      {"0x1p400001", "the binary exponent is beyond 400000"}, {"0x1p-99999999999999999999", "the binary exponent is beyond 400000"},
      {std::string(longest_number + 1, '7'), "longer than 1000000 characters"}};
  // clang-format on
  for (const auto& [token, reason] : table) {
    const ParsedNumber parsed = parse_number(token, Decimals::exact);
    EXPECT_FALSE(parsed.value.has_value()) << parsed.error;
    EXPECT_TRUE(parsed.error.starts_with("expected a number, found '")) << parsed.error;
    EXPECT_NE(parsed.error.find(std::string("': ") + reason), std::string::npos) << parsed.error;
    EXPECT_LT(parsed.error.size(), 140u);
  }
  EXPECT_EQ(parse_number("", Decimals::exact).error, "expected a number, found nothing");
  EXPECT_EQ(parse_number("1/0", Decimals::binary64).error, "expected a number, found '1/0': the denominator is zero");
  const std::string long_noise = parse_number(std::string(100, 'x') + "\x1b[2J", Decimals::exact).error;
  EXPECT_EQ(long_noise, "expected a number, found '" + std::string(40, 'x') + "...': unexpected 'x'");
}

/// Twin: the grammar as one regular expression, the value digit by digit.
std::optional<mpq_class> naive(const std::string& token) {
  static const std::regex grammar(
      R"(([+-]?)(?:(\d+)/(\d+)|0[xX](?=\.?[\da-fA-F])([\da-fA-F]*)\.?([\da-fA-F]*)(?:[pP]([+-]?\d+))?|)"
      R"((?=\.?\d)(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?))");
  std::smatch match;
  if (!std::regex_match(token, match, grammar)) return std::nullopt;
  const auto positional = [](const std::string& whole, const std::string& fraction, long base) {
    mpq_class value = 0, weight = 1;
    const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 32) - 'a' + 10; };
    for (const char c : whole) value = value * base + digit(c);
    for (const char c : fraction) value += digit(c) * (weight /= base);
    return value;
  };
  mpq_class value;
  if (match[2].matched) {
    const mpq_class denominator = positional(match[3], "", 10);
    if (denominator == 0) return std::nullopt;
    value = positional(match[2], "", 10) / denominator;
  } else {
    const bool hex = match[4].matched;
    value = hex ? positional(match[4], match[5], 16) : positional(match[7], match[8], 10);
    const auto& exponent = match[hex ? 6 : 9];
    for (long k = exponent.length() > 0 ? std::stol(exponent) : 0; k != 0; k += k > 0 ? -1 : 1) {
      value = k > 0 ? mpq_class(value * (hex ? 2 : 10)) : mpq_class(value / (hex ? 2 : 10));
    }
  }
  return match[1] == "-" ? mpq_class(-value) : value;
}

// Tokens put together from parts that fit each other, most of the time: about as many numbers as
// noise.
TEST(ParseNumber, AsTheGrammarOnNoise) {
  using Parts = std::vector<std::string>;
  // clang-format off
  const Parts fitting[] = {{"", "+", "-"}, {"", "", "0x", "0X"}, {"0", "9", "10", "007", ""}, {".", ".", "", "", "/"}, {"5", "25", "0", ""},
                           {"", "e0", "E-1", "e+2", "p0", "P-3", "p2"}};
  const Parts odd[] = {{"--", "+-", " ", "\t"}, {"x", "0x0x", "0"}, {"a", "F", "inf", "nan", "1e", "1_0"}, {"..", "-", "//", ".+"},
                       {"fF", ".5", "/0"}, {"e", "p", "e+-2", "p+", "e1.", "x", " ", "/3", "f", "e1e1"}};
  // clang-format on
  int accepted = 0, refused = 0;
  EXPECT_TRUE(holds({.seed = 21, .runs = 4000}, [&] {
    std::string token;
    for (std::size_t i = 0; i < std::size(fitting); ++i) {
      token += *rc::gen::elementOf(random_in(0, 12) == 0 ? odd[i] : fitting[i]);
    }
    const ParsedNumber parsed = parse_number(token, Decimals::exact);
    RC_ASSERT(parsed.value == naive(token));
    RC_ASSERT(parsed.value.has_value() == parsed.error.empty());
    ++(parsed.value ? accepted : refused);
  }));
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 1000);
}

TEST(ParseNumber, DecimalsAsTheNaiveTwin) {
  EXPECT_TRUE(holds({.seed = 21, .runs = 4000}, [] {
    const std::string whole = std::to_string(random_word() >> random_in(0, 64));
    const std::string fraction = std::to_string(random_word()) + std::string(random_in(0, 4), '0');
    const std::string token = whole + "." + fraction + "e" + std::to_string(random_in(-99, 100));
    RC_ASSERT(parse_number(token, Decimals::exact).value == naive(token));
  }));
}

/// What strtod and from_chars both make of `token`; infinity where from_chars finds it too large.
double standard(const std::string& token) {
  const double by_strtod = std::strtod(token.c_str(), nullptr);
  double by_from_chars = 0;
  const auto [end, fault] = std::from_chars(token.data(), token.data() + token.size(), by_from_chars);
  EXPECT_EQ(end, token.data() + token.size());
  if (fault == std::errc{}) {
    EXPECT_EQ(by_strtod, by_from_chars) << token;
  } else {
    EXPECT_TRUE(by_strtod == 0 || std::isinf(by_strtod)) << token;  // out of range at either end
  }
  return by_strtod;
}

void expect_as_standard(const std::string& token) {
  const double expected = standard(token);
  const ParsedNumber parsed = parse_number(token, Decimals::binary64);
  EXPECT_EQ(parsed.value.has_value(), std::isfinite(expected)) << token;
  if (parsed.value && std::isfinite(expected)) {
    EXPECT_EQ(*parsed.value, exact_value(expected)) << token;
  }
}

TEST(ParseNumber, Binary64AsTheStandardLibraryReads) {
  EXPECT_TRUE(holds({.seed = 21, .runs = 4000}, [] {
    const std::string digits = std::to_string(random_word() >> random_in(0, 64));
    expect_as_standard(digits + ".e" + std::to_string(random_in(-360, 330)));
    expect_as_standard("0." + digits + std::to_string(random_word()));
    char shortest[64];
    *std::to_chars(shortest, shortest + sizeof shortest, random_double(), std::chars_format::scientific).ptr = '\0';
    expect_as_standard(shortest);
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

// The middle of two neighbouring doubles, written out in full (up to 768 digits), and the decimals
// next to it.
TEST(ParseNumber, Binary64OnTiesWrittenOut) {
  EXPECT_TRUE(holds({.seed = 21, .runs = 4000}, [] {
    const double x = random_in(0, 4) == 0 ? std::bit_cast<double>(random_word() >> 12) : random_double();
    const double next = std::nextafter(x, HUGE_VAL);
    const mpq_class high = std::isinf(next) ? mpq_class(power(2, 1024)) : exact_value(next);
    const std::string middle = expansion(mpq_class((exact_value(x) + high) / 2));
    expect_as_standard(middle);
    expect_as_standard(middle + "00000000000000000001");
    std::string below = middle;
    below.back() =
        below.back() == '.' ? '.' : static_cast<char>(below.back() - 1);  // the last digit is a 5, or there is none
    expect_as_standard(below + "99999999999999999999");
    RC_ASSERT(!::testing::Test::HasFailure());
  }));
}

TEST(ParseNumber, HexFloatsAndRatiosComeBack) {
  EXPECT_TRUE(holds({.seed = 21, .runs = 4000}, [] {
    const double x = random_double();
    const float y = std::bit_cast<float>(static_cast<std::uint32_t>(random_word()));
    for (const Decimals decimals : {Decimals::exact, Decimals::binary64}) {
      RC_ASSERT(parse_number(hex_text(x), decimals).value == exact_value(x));
      if (std::isfinite(y)) RC_ASSERT(parse_number(hex_text(y), decimals).value == exact_value(y));
      const mpq_class q = exact_value(x) / 3 + exact("1/7");
      RC_ASSERT(parse_number(exact_text(q), decimals).value == q);
    }
    RC_ASSERT(parse_number(expansion(exact_value(x)), Decimals::exact).value == exact_value(x));
  }));
}

/// The twin takes the bit pattern apart.
TEST(ExactValue, IsTheBitPattern) {
  EXPECT_TRUE(holds({.seed = 21, .runs = 4000}, [] {
    for (const std::uint64_t bits : {random_word(), random_word() >> 12, random_word() & ~std::uint64_t{0} << 45}) {
      const double x = std::bit_cast<double>(bits);
      if (!std::isfinite(x)) continue;
      const long biased = static_cast<long>(bits >> 52) & 0x7ff;
      mpq_class expected = mpq_class(std::to_string(bits & ((std::uint64_t{1} << 52) - 1)));
      if (biased != 0) expected += mpq_class(power(2, 52));
      expected = expected * mpq_class(power(2, biased == 0 ? 1 : biased)) / mpq_class(power(2, 1075));
      RC_ASSERT(exact_value(x) == (bits >> 63 != 0 ? mpq_class(-expected) : expected));
    }
  }));
  EXPECT_EQ(exact_value(0.1f), mpq_class("13421773/134217728"));
  EXPECT_EQ(exact_value(-0.0), 0);
  EXPECT_THROW(exact_value(HUGE_VAL), std::invalid_argument);
  EXPECT_THROW(exact_value(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(ParseNumber, VeryLongTokens) {
  const std::string nines(longest_number - 10, '9');
  EXPECT_EQ(exact(nines), mpq_class(power(10, static_cast<long>(nines.size())) - 1));
  EXPECT_EQ(exact("0." + nines), 1 - mpq_class(1, power(10, static_cast<long>(nines.size()))));
  EXPECT_EQ(parse_number("0." + nines, Decimals::binary64).value, mpq_class(1));
  const std::string zeros(500000, '0');
  EXPECT_EQ(exact("0." + zeros + "1e100000"), mpq_class(1, power(10, 400001)));
  EXPECT_EQ(parse_number("0." + zeros + "15e500001", Decimals::binary64).value, mpq_class(3, 2));
  EXPECT_EQ(parse_number("15" + zeros + "e-500001", Decimals::binary64).value, mpq_class(3, 2));
  EXPECT_EQ(exact(zeros + "1/" + zeros.substr(10) + "2"), mpq_class(1, 2));
  EXPECT_EQ(exact("1e" + zeros + "2"), 100);
  EXPECT_EQ(exact("0x" + zeros + "1." + zeros.substr(10)), 1);
}

struct CommaAndGrouping : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

TEST(ParseNumber, NeitherLocaleNorRoundingModeMatter) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaAndGrouping));
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const ParsedNumber three_tenths = parse_number("0.3", Decimals::binary64),
                       exactly = parse_number("1234.5", Decimals::exact);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(three_tenths.value, mpq_class("5404319552844595/18014398509481984"));
    EXPECT_EQ(exact_text(*exactly.value), "2469/2");
  }
  EXPECT_EQ(exact_text(mpq_class(-1234567)), "-1234567");
  std::locale::global(before);
}

// The quick reader against its naive twin: it leaves a token alone, or agrees exactly.

/// Whether the quick reader took the token; if so it must agree.
bool quick(const std::string& token, Decimals decimals) {
  const std::optional<double> value = quick_number(token, decimals);
  if (!value) return false;
  const ParsedNumber naive = parse_number(token, decimals);
  EXPECT_TRUE(naive.value.has_value()) << token;
  EXPECT_EQ(mpq_class(*value), naive.value.value_or(mpq_class(-54321))) << token;
  return true;
}

/// Expects that the whole token is read, as the naive reader does.
void expect_leading(const std::string& token, const std::string& behind = "") {
  const std::string text = token + behind;
  double nearest = 0;
  const char* const end = leading_number(text.data(), text.data() + text.size(), nearest);
  ASSERT_NE(end, nullptr) << token;
  EXPECT_EQ(end - text.data(), static_cast<std::ptrdiff_t>(token.size())) << text;
  const ParsedNumber naive = parse_number(token, Decimals::exact);
  EXPECT_EQ(nearest, round_binary64(*naive.value)) << token;
}

TEST(LeadingNumber, IsTheNearestBinary64AndItsEnd) {
  for (const char* token :  // ties, and what is just off them
       {"9007199254740993", "9007199254740995", "4503599627370496.5", "4503599627370497.5", "4503599627370496.501",
        "4503599627370497.499", "0.5", "1.0000000000000002220", "18446744073709551615", "9999999999999999999",
        "0.9999999999999999999", "0.0000000000000000001", "12345678", "1234567890.12345678", "0", "1e22", "1.5E-7"})
    for (const char* behind : {"", ",", "]", " 1", "x", ",12345678"}) expect_leading(token, behind);
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::string token = std::to_string(random() >> random() % 64);
    if (const std::size_t places = random() % 21; places > 0) {
      token = std::string(places >= token.size() ? places + 1 - token.size() : 0, '0') + token;
      token.insert(token.size() - places, 1, '.');
    }
    expect_leading((random() % 2 != 0 ? "-" : "") + token);
  }
}

TEST(LeadingNumber, IsOneOfJson) {
  for (const std::string text : {"", "-", "+1", ".5", "5.", "5.x", "01", "00", "-01.5", "1e", "1e+", "1e-x", "inf",
                                 "nan", "1e400", "-1e400", "x", "/1", ":1"}) {
    double nearest = 0;
    EXPECT_EQ(leading_number(text.data(), text.data() + text.size(), nearest), nullptr) << text;
  }
}

TEST(NearestBinary64, IsThatOfTheNaiveReaderAndHasNoLongestNumber) {
  for (const char* token :
       {"0.0", "-2.5", "1e308", "17976931348623157e292", "4.9e-324", "1e-400", "-1e-400", "0.001e-399"})
    EXPECT_EQ(mpq_class(nearest_binary64(token)), *parse_number(token, Decimals::binary64).value) << token;
  const std::string zeros(2'000'000, '0');
  EXPECT_EQ(nearest_binary64("1" + zeros + "e-2000000"), 1);
  EXPECT_EQ(nearest_binary64("0." + zeros + "25e2000000"), 0.25);
  EXPECT_EQ(nearest_binary64("0." + zeros + "1"), 0);
  for (const std::string& token : {std::string("1e400"), "1" + zeros, "0." + zeros + "1e2001000"})
    EXPECT_EQ(nearest_binary64(token), HUGE_VAL);
  EXPECT_EQ(nearest_binary64("-1e99999999999999999999"), -HUGE_VAL);
  EXPECT_EQ(nearest_binary64("1e-99999999999999999999"), 0);
}

TEST(QuickNumber, TakesWhatMeshesHold) {
  for (const char* token : {"0", "-0", "007", "9007199254740992", "-9007199254740992"}) {
    EXPECT_TRUE(quick(token, Decimals::binary64)) << token;
    EXPECT_TRUE(quick(token, Decimals::exact)) << token;
  }
  for (const char* token : {"0.1", "-.5", "1.", "1e5", "1.25E-7", "0.30000000000000004", "9007199254740993.0",
                            "2.2250738585072012e-308", "1.7976931348623157e308", "4.9406564584124654e-324"}) {
    EXPECT_TRUE(quick(token, Decimals::binary64)) << token;
    EXPECT_FALSE(quick(token, Decimals::exact)) << token;
  }
}

TEST(QuickNumber, LeavesTheRest) {
  std::vector<std::string> all = testing::words(
      R"(+1 - . inf -inf nan infinity 1e400 -1e400 1e-400 0x1p3 0x1.8 1/2 1e 1e+ 1,5 9007199254740993 -9007199254740993
      1.5f --1 nan(e1))");
  all.insert(all.end(), {"", "1 ", " 1"});
  for (const std::string& token : all) {
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
  EXPECT_TRUE(holds({.seed = 34, .runs = 20000}, [&] {
    std::string token;
    for (const std::string& piece : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(pieces)))
      token += piece;
    quick(token, Decimals::binary64);
    quick(token, Decimals::exact);
  }));
  EXPECT_TRUE(holds({.seed = 34, .runs = 20000}, [&] {
    const auto digits = *rc::gen::container<std::string>(rc::gen::inRange<char>('0', '9' + 1));
    const int exponent = *rc::gen::inRange(-330, 315);
    quick("0." + digits + "e" + std::to_string(exponent), Decimals::binary64);
    quick(digits, Decimals::binary64);
  }));
}

TEST(QuickNumber, LeavesDecimalsWhileRoundingIsNotToNearest) {
  std::fesetround(FE_UPWARD);
  const bool decimal = quick_number("0.1", Decimals::binary64).has_value(),
             integer = quick_number("12", Decimals::binary64).has_value();
  std::fesetround(FE_TONEAREST);
  EXPECT_FALSE(decimal);
  EXPECT_TRUE(integer);
}

}  // namespace
}  // namespace fathom::kernels

// Laws: points in binary64 and the same exact points cannot be told apart, except by asking for the
// form; both forms may be asked for at once; a change is a change of the exact points.

namespace fathom {
namespace {

using Doubles = std::vector<std::array<double, 3>>;

const Doubles doubles{{0, 0.5, -3}, {0x1p-1074, -0x1p1000, 0.1}};
const std::vector<Point> points{{0, mpq_class(1, 2), -3}, {mpq_class(0x1p-1074), mpq_class(-0x1p1000), mpq_class(0.1)}};

TEST(GivenPoints, AreTheSameInBothForms) {
  const GivenPoints given(doubles), exact(points);
  EXPECT_TRUE(given.in_binary64());
  EXPECT_FALSE(exact.in_binary64());
  EXPECT_TRUE(exact.binary64().empty());
  EXPECT_TRUE(given == exact);
  EXPECT_EQ(given.size(), 2U);
  EXPECT_EQ(given.exact(), points);
  EXPECT_EQ(std::vector<Point>(given.begin(), given.end()), points);
  EXPECT_EQ(given[1], points[1]);
  EXPECT_EQ(given.front(), points.front());
  EXPECT_EQ(given.back(), points.back());
  EXPECT_TRUE(given == GivenPoints(doubles));
  EXPECT_FALSE(given == GivenPoints(Doubles{{0, 0.5, -3}, {0x1p-1073, -0x1p1000, 0.1}}));
  EXPECT_FALSE(given == GivenPoints(Doubles{{0, 0.5, -3}}));
}

TEST(GivenPoints, KnowNoMinusZero) {
  const GivenPoints given(Doubles{{-0.0, 1, -0.0}});
  EXPECT_FALSE(std::signbit(given.binary64()[0][0]));
  EXPECT_TRUE(given == GivenPoints(Doubles{{0, 1, 0}}));
}

TEST(GivenPoints, AreFinite) {
  for (const double bad : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()})
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Doubles with_bad = doubles;
      with_bad[1][axis] = bad;
      EXPECT_THROW(GivenPoints{with_bad}, std::invalid_argument) << bad;
    }
}

TEST(GivenPoints, OfNoneAreExact) {
  EXPECT_FALSE(GivenPoints(Doubles()).in_binary64());
  EXPECT_TRUE(GivenPoints(Doubles()).empty());
}

TEST(GivenPoints, AreChangedAsExactPoints) {
  GivenPoints changed(doubles);
  const GivenPoints copy = changed;
  changed.edit()[0].x = mpq_class(1, 3);
  changed.push_back({1, 2, 3});
  EXPECT_FALSE(changed.in_binary64());
  EXPECT_EQ(changed.size(), 3U);
  EXPECT_EQ(changed[0].x, mpq_class(1, 3));
  EXPECT_TRUE(copy.in_binary64());
  EXPECT_EQ(copy.exact(), points) << "a copy is not changed";
}

TEST(GivenPoints, BecomeExactOnceForAll) {
  const GivenPoints given(doubles), copy = given;
  std::vector<const Point*> found(8);
  std::vector<std::thread> threads;
  for (const Point*& place : found) threads.emplace_back([&] { place = given.data(); });
  for (std::thread& thread : threads) thread.join();
  for (const Point* place : found) EXPECT_EQ(place, copy.data());
}

}  // namespace
}  // namespace fathom
