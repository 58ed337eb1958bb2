// SPDX-License-Identifier: GPL-3.0-or-later
// The checker's own reading of case files: numbers, JSON, and the comparison with a certificate's points.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include "verify/check/cases.hpp"
#include "verify/check/number.hpp"
#include "verify/check/parser.hpp"
#include "verify/check/result.hpp"

namespace fathom_check {
namespace {

[[maybe_unused]] const int configured = setenv("RC_PARAMS", "seed=11 max_success=2000", 0);  // the same numbers in every run

std::string exact(std::string_view text) {
  const std::optional<mpq_class> value = exact_number(text);
  return value ? value->get_str() : "none";
}

std::string nearest(std::string_view text) {
  const std::optional<mpq_class> value = nearest_binary64(text);
  return value ? value->get_str() : "none";
}

TEST(CheckNumber, ExactForms) {
  EXPECT_EQ(exact("12"), "12");
  EXPECT_EQ(exact("-007"), "-7");
  EXPECT_EQ(exact("+6/4"), "3/2");
  EXPECT_EQ(exact("0.1"), "1/10");
  EXPECT_EQ(exact("-.5"), "-1/2");
  EXPECT_EQ(exact("5."), "5");
  EXPECT_EQ(exact("1e3"), "1000");
  EXPECT_EQ(exact("125E-2"), "5/4");
  EXPECT_EQ(exact("0x1.8p1"), "3");
  EXPECT_EQ(exact("-0XAp-2"), "-5/2");
  EXPECT_EQ(exact("0x.8"), "1/2");
  for (const char* text : {"",
                           "-",
                           "1/0",
                           "1/",
                           "/2",
                           "1/-2",
                           "1e",
                           "e5",
                           ".",
                           "0x",
                           "0xp3",
                           "1 ",
                           " 1",
                           "nan",
                           "inf",
                           "1/2/3",
                           "--1",
                           "1e100001",
                           "1e-100001",
                           "0x1p400001",
                           "1e99999999999999999999",
                           "\x0e"
                           "5",
                           "1_000",
                           "0b1"})
    EXPECT_EQ(exact(text), "none") << text;
  EXPECT_EQ(exact("1e100000").size(), 100001U);
}

TEST(CheckNumber, NearestBinary64) {
  EXPECT_EQ(nearest("0.5"), "1/2");
  EXPECT_EQ(nearest("0.1"), "3602879701896397/36028797018963968");
  EXPECT_EQ(nearest("9007199254740993"), "9007199254740992");
  EXPECT_EQ(nearest("9007199254740995"), "9007199254740996");
  EXPECT_EQ(nearest("1e400"), "none");
  EXPECT_EQ(nearest("1.7976931348623158e308").size(), 309U);
  EXPECT_EQ(nearest("1.7976931348623159e308"), "none");
  EXPECT_EQ(nearest("-1e999999999999"), "none");
  EXPECT_EQ(nearest("0e999999999999"), "0");
  EXPECT_EQ(nearest("1e-999999999999"), "0");
  EXPECT_EQ(nearest("2e-324"), "0");
  EXPECT_EQ(nearest("3e-324"), mpq_class(1, mpz_class(1) << 1074).get_str());
}

// The standard library's conversion is the twin.
TEST(CheckNumber, AgreesWithTheStandardLibrary) {
  EXPECT_TRUE(rc::check("nearest_binary64 is from_chars", [] {
    const auto digits = *rc::gen::inRange<std::int64_t>(-4'000'000'000'000'000'000, 4'000'000'000'000'000'000);
    const std::string text =
        std::to_string(digits) + "." + std::to_string(*rc::gen::inRange(0, 1000)) + "e" + std::to_string(*rc::gen::inRange(-345, 292));
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::optional<mpq_class> found = nearest_binary64(text);
    if (result.ec == std::errc::result_out_of_range && std::abs(value) > 1) RC_FAIL("the range of exponents is too large");
    RC_ASSERT(found.has_value());
    RC_ASSERT(*found == mpq_class(result.ec == std::errc() ? value : 0.0));
  }));
  EXPECT_TRUE(rc::check("every binary64 stays", [] {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    RC_PRE(std::isfinite(value));
    mpq_class rounded(value);
    RC_ASSERT(round_to_binary64(rounded));
    RC_ASSERT(rounded == mpq_class(value));
  }));
}

Certificate certificate(const std::string& id, const std::string& a, const std::string& b) {
  const std::string text = "fathom-certificate 1\n" + (id.empty() ? "" : "id " + id + "\n") + "a 1\n" + a + "\nb 1\n" + b +
                           "\nclaim disjoint\ndirections 1 some\n0 0 1\nend 1 1 1 0 0\n";
  Lines lines(text, longest_line);
  Parser parser(lines);
  Certificate result;
  Budget budget;
  EXPECT_TRUE(parser.find_next());
  parser.read(result, budget);
  return result;
}

std::string compared(const std::string& cases, const Certificate& certificate) {
  try {
    CaseFile(cases).compare(certificate);
    return "";
  } catch (const Fault& fault) {
    return (fault.malformed ? "malformed: " : "refused: ") + std::string(fault.what());
  }
}

std::string body(const std::string& point, const std::string& more = "") { return "{\"vertices\": [[" + point + "]]" + more + "}"; }

TEST(CheckCase, PointsAreCompared) {
  const Certificate c = certificate("", "3602879701896397/36028797018963968 2/4 -3", "1/10 0 7");
  const auto text = [](const std::string& a, const std::string& b) { return "{\"a\": " + a + ", \"b\": " + b + "}"; };
  EXPECT_EQ(compared(text(body("0.1, 0.5, -3"), body("\"0.1\", 0, 7e0")), c), "");
  EXPECT_EQ(compared(text(body("\"0.1\", 0.5, -3"), body("\"0.1\", 0, 7")), c), "refused: point 0 of a is not that of the case");
  EXPECT_EQ(compared(text(body("0.1, 0.5, -3"), body("0.1, 0, 7")), c), "refused: point 0 of b is not that of the case");
  for (const char* other : {"0, 0.5, -3", "0.1, 0, -3", "0.1, 0.5, 3"})
    EXPECT_EQ(compared(text(body(other), body("\"0.1\", 0, 7")), c), "refused: point 0 of a is not that of the case") << other;
  EXPECT_EQ(compared(text("{\"vertices\": []}", body("\"0.1\", 0, 7")), c), "refused: the case has 0 points in a, the certificate 1");
}

TEST(CheckCase, PosesAreApplied) {
  const Certificate c = certificate("", "-1 3 2", "1 1 1");
  const std::string pose = ", \"pose\": [[0, -1, 0, \"1\"], [1, 0, 0, 2], [0, 0, 1, 0]]";
  EXPECT_EQ(compared("{\"a\": " + body("1, 2, 2", pose) + ", \"b\": " + body("1, 1, 1", ", \"pose\": null") + "}", c), "");
  EXPECT_NE(compared("{\"a\": " + body("1, 2, 2") + ", \"b\": " + body("1, 1, 1") + "}", c), "");
  const std::string third = ", \"pose\": [[\"1/3\", 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]";
  const Certificate exact = certificate("", "1/3 0 0", "1 1 1"),
                    rounded = certificate("", "6004799503160661/18014398509481984 0 0", "1 1 1");
  for (const bool of_case : {false, true}) {
    const std::string rounding = ", \"pose_rounding\": \"binary64\"";
    const std::string text =
        "{\"a\": " + body("1, 0, 0", third + (of_case ? "" : rounding)) + ", \"b\": " + body("1, 1, 1") + (of_case ? rounding : "") + "}";
    EXPECT_EQ(compared(text, rounded), "");
    EXPECT_NE(compared(text, exact), "");
  }
  EXPECT_EQ(compared("{\"a\": " + body("1, 0, 0", third) + ", \"b\": " + body("1, 1, 1") + "}", exact), "");
}

TEST(CheckCase, CasesAreFoundById) {
  const auto line = [](const std::string& id, int x) {
    return "{" + id + "\"a\": " + body(std::to_string(x) + ", 0, 0") + ", \"b\": " + body("1, 1, 1") + "}\n";
  };
  const std::string cases = line("\"id\": \"\\u00e9 %\", ", 1) + line("\"id\": 7, ", 2) + line("", 3);
  EXPECT_EQ(compared(cases, certificate("%C3%A9 %25", "1 0 0", "1 1 1")), "");
  EXPECT_EQ(compared(cases, certificate("7", "2 0 0", "1 1 1")), "");
  EXPECT_EQ(compared(cases, certificate("3", "3 0 0", "1 1 1")), "") << "the number of its line";
  EXPECT_EQ(compared(cases, certificate("7", "1 0 0", "1 1 1")), "refused: point 0 of a is not that of the case");
  EXPECT_EQ(compared(cases, certificate("8", "1 0 0", "1 1 1")), "refused: no case has this id");
  EXPECT_EQ(compared(cases, certificate("", "1 0 0", "1 1 1")), "refused: without an id, none of the cases can be found");
  EXPECT_EQ(compared(cases + line("\"id\": \"7\", ", 2), certificate("7", "2 0 0", "1 1 1")), "refused: several cases have this id");
  EXPECT_EQ(compared(line("\"id\": \"x\", ", 1), certificate("y", "1 0 0", "1 1 1")), "") << "the only case";
}

TEST(CheckCase, BadCasesAreMalformed) {
  const Certificate c = certificate("", "1 0 0", "1 1 1");
  const std::string b = ", \"b\": " + body("1, 1, 1") + "}";
  for (const std::string& text : std::vector<std::string>{
           "", "[]", "{}", "{\"a\": 1" + b, "{\"a\": " + body("1, 0") + b, "{\"a\": " + body("1, 0, 1e400") + b,
           "{\"a\": " + body("1, 0, \"x\"") + b, "{\"a\": " + body("1, 0, true") + b,
           "{\"schema\": \"other\", \"a\": " + body("1, 0, 0") + b, "{\"a\": " + body("1, 0, 0") + ", \"a\": " + body("1, 0, 0") + b,
           "{\"a\": " + body("1, 0, 0", ", \"pose\": [[1]]") + b, "{\"a\": " + body("1, 0, 0", ", \"pose_rounding\": \"binary32\"") + b,
           "{\"a\": " + body("01, 0, 0") + b, "{\"a\": " + body("1, 0, 0") + b + "}", "{\"a\": " + body("1, 0, 0") + b + ",",
           "{\"a\": " + body("1, 0, .5") + b, "{\"a\": " + body("NaN, 0, 0") + b})
    EXPECT_EQ(compared(text, c).substr(0, 10), "malformed:") << text;
  EXPECT_EQ(compared("{\"more\": {\"deep\": [1, [2, {}]]}, \"a\": " + body("1, 0, 0") + b, c), "") << "unknown fields are passed over";
}

TEST(CheckResult, SaysWhatTheCertificateSays) {
  const Certificate c = certificate("", "1 0 0", "1 1 1");
  const auto said = [&c](const std::string& fields) {
    try {
      Result result;
      read_result("{\"certificate\": \"\"" + fields + "}", 1, result);
      compare(result, c);
      return true;
    } catch (const Fault&) {
      return false;
    }
  };
  EXPECT_TRUE(said(""));
  EXPECT_TRUE(said(", \"status\": \"disjoint\", \"depth\": {\"squared\": \"0\"}"));
  EXPECT_FALSE(said(", \"status\": \"touching\""));
  EXPECT_FALSE(said(", \"depth\": {\"squared\": \"1\"}"));
  EXPECT_FALSE(said(", \"depth\": {\"squared\": 0}"));
  Result result;
  EXPECT_THROW(read_result("{}", 1, result), Fault);
  EXPECT_THROW(read_result("{\"certificate\": \"\"} {}", 1, result), Fault);
}

}  // namespace
}  // namespace fathom_check
