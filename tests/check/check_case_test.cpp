// SPDX-License-Identifier: GPL-3.0-or-later
// The checker's own reading of case files: numbers, JSON, and the comparison with a certificate's
// points.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <string>

#include "tests/support/property.hpp"
#include "verify/check/comparisons.hpp"
#include "verify/check/json.hpp"
#include "verify/check/limits.hpp"
#include "verify/check/parser.hpp"

namespace fathom_check {
namespace {

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
  EXPECT_TRUE(fathom::holds({.seed = 11, .runs = 2000}, [] {
    const auto digits = *rc::gen::inRange<std::int64_t>(-4'000'000'000'000'000'000, 4'000'000'000'000'000'000);
    const std::string text = std::to_string(digits) + "." + std::to_string(*rc::gen::inRange(0, 1000)) + "e" +
                             std::to_string(*rc::gen::inRange(-345, 292));
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::optional<mpq_class> found = nearest_binary64(text);
    if (result.ec == std::errc::result_out_of_range && std::abs(value) > 1)
      RC_FAIL("the range of exponents is too large");
    RC_ASSERT(found.has_value());
    RC_ASSERT(*found == mpq_class(result.ec == std::errc() ? value : 0.0));
  }));
  EXPECT_TRUE(fathom::holds({.seed = 11, .runs = 2000}, [] {
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
  const std::string text = "fathom-certificate 1\n" + (id.empty() ? "" : "id " + id + "\n") + "a 1\n" + a + "\nb 1\n" +
                           b + "\nclaim disjoint\ndirections 1 some\n0 0 1\nend 1 1 1 0 0\n";
  Lines lines(text, longest_line);
  Parser parser(lines);
  Certificate result;
  EXPECT_TRUE(parser.find_next());
  parser.read(result);
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

std::string body(const std::string& point, const std::string& more = "") {
  return "{\"vertices\": [[" + point + "]]" + more + "}";
}

TEST(CheckCase, PointsAreCompared) {
  const Certificate c = certificate("", "3602879701896397/36028797018963968 2/4 -3", "1/10 0 7");
  const auto text = [](const std::string& a, const std::string& b) { return "{\"a\": " + a + ", \"b\": " + b + "}"; };
  EXPECT_EQ(compared(text(body("0.1, 0.5, -3"), body("\"0.1\", 0, 7e0")), c), "");
  EXPECT_EQ(compared(text(body("\"0.1\", 0.5, -3"), body("\"0.1\", 0, 7")), c),
            "refused: point 0 of a is not that of the case");
  EXPECT_EQ(compared(text(body("0.1, 0.5, -3"), body("0.1, 0, 7")), c),
            "refused: point 0 of b is not that of the case");
  for (const char* other : {"0, 0.5, -3", "0.1, 0, -3", "0.1, 0.5, 3"})
    EXPECT_EQ(compared(text(body(other), body("\"0.1\", 0, 7")), c), "refused: point 0 of a is not that of the case")
        << other;
  EXPECT_EQ(compared(text("{\"vertices\": []}", body("\"0.1\", 0, 7")), c),
            "refused: the case has 0 points in a, the certificate 1");
}

TEST(CheckCase, PosesAreApplied) {
  const Certificate c = certificate("", "-1 3 2", "1 1 1");
  const std::string pose = ", \"pose\": [[0, -1, 0, \"1\"], [1, 0, 0, 2], [0, 0, 1, 0]]";
  EXPECT_EQ(compared("{\"a\": " + body("1, 2, 2", pose) + ", \"b\": " + body("1, 1, 1", ", \"pose\": null") + "}", c),
            "");
  EXPECT_NE(compared("{\"a\": " + body("1, 2, 2") + ", \"b\": " + body("1, 1, 1") + "}", c), "");
  const std::string third = ", \"pose\": [[\"1/3\", 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]";
  const Certificate exact = certificate("", "1/3 0 0", "1 1 1"),
                    rounded = certificate("", "6004799503160661/18014398509481984 0 0", "1 1 1");
  for (const bool of_case : {false, true}) {
    const std::string rounding = ", \"pose_rounding\": \"binary64\"";
    const std::string text = "{\"a\": " + body("1, 0, 0", third + (of_case ? "" : rounding)) +
                             ", \"b\": " + body("1, 1, 1") + (of_case ? rounding : "") + "}";
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
  EXPECT_EQ(compared(cases, certificate("%C3%A9%20%25", "1 0 0", "1 1 1")), "");
  EXPECT_EQ(compared(cases, certificate("7", "2 0 0", "1 1 1")), "");
  EXPECT_EQ(compared(cases, certificate("3", "3 0 0", "1 1 1")), "") << "the number of its line";
  EXPECT_EQ(compared(cases, certificate("7", "1 0 0", "1 1 1")), "refused: point 0 of a is not that of the case");
  EXPECT_EQ(compared(cases, certificate("8", "1 0 0", "1 1 1")), "refused: no case has this id");
  EXPECT_EQ(compared(cases, certificate("", "1 0 0", "1 1 1")),
            "refused: without an id, none of the cases can be found");
  EXPECT_EQ(compared(cases + line("\"id\": \"7\", ", 2), certificate("7", "2 0 0", "1 1 1")),
            "refused: several cases have this id");
  EXPECT_EQ(compared(line("\"id\": \"x\", ", 1), certificate("y", "1 0 0", "1 1 1")), "") << "the only case";
}

// The result's id counts, not the certificate's, even if there is one case only.
TEST(CheckCase, AResultIsFoundByItsOwnId) {
  const std::string x = "{\"id\": \"x\", \"a\": " + body("1, 0, 0") + ", \"b\": " + body("1, 1, 1") + "}\n";
  const std::string y = "{\"id\": \"y\", \"a\": " + body("2, 0, 0") + ", \"b\": " + body("1, 1, 1") + "}\n";
  const Certificate of_x = certificate("x", "1 0 0", "1 1 1");
  EXPECT_NO_THROW(CaseFile(x + y).compare(of_x, false, "x"));
  EXPECT_THROW(CaseFile(x + y).compare(of_x, false, "y"), Fault);
  EXPECT_THROW(CaseFile(x).compare(of_x, false, "y"), Fault);
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(CheckCase, BadCasesAreMalformed) {
  const Certificate c = certificate("", "1 0 0", "1 1 1");
  const std::string b = ", \"b\": " + body("1, 1, 1") + "}";
  for (const std::string& text :
       std::vector<std::string>{"",
                                "[]",
                                "{}",
                                "{\"a\": 1" + b,
                                "{\"a\": " + body("1, 0") + b,
                                "{\"a\": " + body("1, 0, 1e400") + b,
                                "{\"a\": " + body("1, 0, \"x\"") + b,
                                "{\"a\": " + body("1, 0, true") + b,
                                "{\"schema\": \"other\", \"a\": " + body("1, 0, 0") + b,
                                "{\"a\": " + body("1, 0, 0") + ", \"a\": " + body("1, 0, 0") + b,
                                "{\"a\": " + body("1, 0, 0", ", \"pose\": [[1]]") + b,
                                "{\"a\": " + body("1, 0, 0", ", \"pose_rounding\": \"binary32\"") + b,
                                "{\"a\": " + body("01, 0, 0") + b,
                                "{\"a\": " + body("1, 0, 0") + b + "}",
                                "{\"a\": " + body("1, 0, 0") + b + ",",
                                "{\"a\": " + body("1, 0, .5") + b,
                                "{\"a\": " + body("NaN, 0, 0") + b,
                                "{\"a\": " + body("1, 0, 0") + b + std::string(1, '\0') + "junk",
                                "{\"name\": \"\xc3(\", \"a\": " + body("1, 0, 0") + b,
                                "{\"skipped\": " + nested(64) + ", \"a\": " + body("1, 0, 0") + b})
    EXPECT_EQ(compared(text, c).substr(0, 10), "malformed:") << text;
  EXPECT_EQ(compared("{\"skipped\": " + nested(63) + ", \"a\": " + body("1, 0, 0") + b, c), "")
      << "64 deep with the case itself";
  EXPECT_EQ(compared("{\"more\": {\"deep\": [1, [2, {}]]}, \"a\": " + body("1, 0, 0") + b, c), "")
      << "unknown fields are passed over";
}

/// What becomes of a line of results with the certificate's fields and these.
std::string said(const std::string& fields, const Certificate& c) {
  try {
    Result result;
    read_result("{\"certificate\": \"\"" + fields + "}", 1, result);
    compare(result, c);
    return "fine";
  } catch (const Fault& fault) {
    return fault.malformed ? "malformed" : "refused";
  }
}

TEST(CheckResult, SaysWhatTheCertificateSays) {
  const Certificate c = certificate("a%20b", "1 0 0", "1 1 1");
  EXPECT_EQ(said("", c), "fine");
  EXPECT_EQ(said(R"(, "id": "a b", "status": "disjoint", "depth": {"squared": "-0/7"}, "bound": {"squared": "00"})", c),
            "fine");
  EXPECT_EQ(said(R"(, "depth": {"squared": "0", "value": 7, "rounded": null}, "other": "\u00e9", "witness": null)", c),
            "fine");
  for (const char* fields :
       {R"(, "id": "a%20b")", R"(, "id": "b")", R"(, "id": "")", R"(, "id": 7)", R"(, "status": "touching")",
        R"(, "depth": {"squared": "1"})", R"(, "bound": {"squared": "1/9"})", R"(, "depth": {"squared": null})",
        R"(, "signed_depth": {"low": 0, "high": 1})", R"(, "signed_depth": {"low": -1, "high": 1})",
        R"(, "signed_depth": {"low": -1, "high": 0, "exact": {"sign": 1, "root": "1", "plus": "0"}})"})
    EXPECT_EQ(said(fields, c), "refused") << fields;
  EXPECT_EQ(said(R"(, "id": 7)", certificate("", "1 0 0", "1 1 1")), "fine");
  EXPECT_EQ(said(R"(, "signed_depth": {"low": null, "high": 0})", c), "fine");
  EXPECT_EQ(said(R"(, "signed_depth": {"low": null, "high": -1, "exact": {"sign": -1, "root": "1", "plus": "0"}})", c),
            "refused")
      << "that bodies are apart does not prove by how much";
}

// The certificate of a depth says what the signed depth is.
TEST(CheckResult, ADepthIsSigned) {
  Certificate c = certificate("", "1 0 0", "1 1 1");
  c.claim = Claim::depth;
  c.low = c.high = {c.integers.keep(2L), Integer::one()};
  EXPECT_EQ(
      said(R"(, "signed_depth": {"low": 1.414, "high": 1.415, "exact": {"sign": 1, "root": "2", "plus": "0"}})", c),
      "fine");
  for (const char* fields :
       {R"(, "signed_depth": {"low": 1.415, "high": 1.416})", R"(, "signed_depth": {"low": 1.4, "high": 1.41})",
        R"(, "signed_depth": {"low": -1.415, "high": -1.414})",
        R"(, "signed_depth": {"low": 1, "high": 2, "exact": {"sign": -1, "root": "2", "plus": "0"}})"})
    EXPECT_EQ(said(fields, c), "refused") << fields;
}

// depth^2 is null where it is irrational; sqrt(2) + 1 squares to 3 + sqrt(8), sqrt(4) + 1/2 to
// 25/4, -sqrt(4) + 3 to 1.
TEST(CheckResult, SquaresOfRoundedDepths) {
  Certificate c = certificate("", "1 0 0", "1 1 1");
  c.format = 2;
  const auto of = [&](Claim claim, long cores, long radius, long over) {
    c.claim = claim;
    c.low = c.high = {c.integers.keep(cores), Integer::one()};
    c.a.radius = {c.integers.keep(radius), c.integers.keep(over)};
    c.b.radius = {};
  };
  const auto depth = [&](const std::string& square) { return said(R"(, "depth": {"squared": )" + square + "}", c); };
  of(Claim::depth, 2, 1, 1);
  EXPECT_EQ(depth("null"), "fine");
  for (const char* square : {R"("3")", R"("2")", R"("0")", R"("9")"}) EXPECT_EQ(depth(square), "refused") << square;
  of(Claim::depth, 4, 1, 2);
  EXPECT_EQ(depth(R"("25/4")"), "fine");
  for (const char* square : {R"("4")", R"("9/4")", R"("6")"}) EXPECT_EQ(depth(square), "refused") << square;
  of(Claim::apart, 4, 3, 1);
  EXPECT_EQ(depth(R"("1")"), "fine");
  EXPECT_EQ(depth(R"("25")"), "refused") << "that of sqrt(4) + 3";
  of(Claim::apart, 9, 3, 1);
  EXPECT_EQ(depth(R"("0")"), "fine");
  EXPECT_EQ(depth("null"), "refused");
  EXPECT_EQ(said(R"(, "bound": {"squared": "0"})", c), "refused");
}

TEST(CheckResult, NotationsAreThoseOfCertificates) {
  const Certificate c = certificate("", "1 0 0", "1 1 1");
  for (const char* squared :
       {"+0", "0.", ".0", "0x0p+0", "0e0", "", " 0", "0 ", "0/0", "0/-1", "0/+1", "-", "/1", "0/1/1", "nan"})
    EXPECT_EQ(said(R"(, "depth": {"squared": ")" + std::string(squared) + R"("})", c), "malformed") << squared;
  EXPECT_EQ(said(R"(, "depth": {"squared": ")" + std::string(longest_number, '0') + R"("})", c), "fine");
  EXPECT_EQ(said(R"(, "depth": {"squared": ")" + std::string(longest_number + 1, '0') + R"("})", c), "malformed");
}

TEST(CheckResult, OtherKindsOfFieldsAreMalformed) {
  const Certificate c = certificate("", "1 0 0", "1 1 1");
  for (const std::string& fields : std::vector<std::string>{
           R"(, "id": true)", R"(, "id": null)", R"(, "status": null)", R"(, "status": 1)", R"(, "depth": "0")",
           R"(, "depth": null)", R"(, "depth": 0)", R"(, "depth": {"value": 1})", R"(, "depth": {"squared": 0})",
           R"(, "bound": "0")", R"(, "depth": {"squared": "0", "squared": "0"})", R"(, "certificate": "")",
           ", \"x\": \"\xff\"", ", \"\xc0\x80\": 1", ", \"x\": " + nested(64)})
    EXPECT_EQ(said(fields, c), "malformed") << fields;
  EXPECT_EQ(said(", \"x\": " + nested(63), c), "fine");
  Result result;
  for (const std::string& line :
       {std::string("{}"), std::string(R"({"certificate": ""} {})"), std::string("{\"certificate\": \"\"}\0", 20),
        std::string("{\"certificate\": \"\"}\0junk", 24), std::string("[]"), std::string("")})
    EXPECT_THROW(read_result(line, 1, result), Fault) << line;
  EXPECT_NO_THROW(read_result("{\"certificate\": \"\"} \t\r", 1, result));
}

// 1/2 <= depth^2 <= 16/5 is not a proof that it is 2, nor that it is 16/5.
TEST(CheckResult, BoundsAreNoDepth) {
  Certificate c = certificate("", "1 0 0", "1 1 1");
  c.claim = Claim::bounds;
  c.low = {Integer::one(), c.integers.keep(2L)};
  c.high = {c.integers.keep(16L), c.integers.keep(5L)};
  EXPECT_EQ(said(R"(, "status": "penetrating")", c), "fine");
  EXPECT_EQ(said(R"(, "depth": {"squared": "16/5"}, "bound": {"squared": "2/4"})", c), "fine");
  for (const char* fields :
       {R"(, "depth": {"squared": "2"})", R"(, "depth": {"squared": "16/5"})", R"(, "depth": {"squared": "1/2"})",
        R"(, "depth": {"squared": "2"}, "bound": {"squared": "1/2"})", R"(, "bound": {"squared": "1/3"})",
        R"(, "depth": {"squared": "16/5"}, "bound": {"squared": "16/5"})"})
    EXPECT_EQ(said(fields, c), "refused") << fields;
  c.low = c.high;
  EXPECT_EQ(said(R"(, "depth": {"squared": "16/5"})", c), "fine");
}

}  // namespace
}  // namespace fathom_check
