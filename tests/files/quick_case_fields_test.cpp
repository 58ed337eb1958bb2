// SPDX-License-Identifier: GPL-3.0-or-later
// The quick reader of cases against its naive twin: on good cases, bad ones, and each with one
// character changed. It may leave a text to the twin, but not the usual ones; what it reads, the
// twin reads too, and finds the same.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "reference/files/case_fields.hpp"
#include "tests/support/words.hpp"

namespace fathom::files {
namespace {

using namespace std::string_literals;

bool same(const BodyFields& a, const BodyFields& b) {
  return a.vertices == b.vertices && a.pose == b.pose && a.rounded == b.rounded;
}

/// Expects that the readers do not differ. Returns whether the quick one read the text.
bool agree(const std::string& text) {
  const std::optional<CaseFields> quick = quick_case_fields(text);
  if (!quick) return false;
  const CaseFields twin = read_case_fields(text, text::read_json(text));
  EXPECT_EQ(twin.fault, "") << text;
  EXPECT_EQ(quick->fault, "") << text;
  EXPECT_EQ(quick->id, twin.id) << text;
  EXPECT_EQ(quick->rounded, twin.rounded) << text;
  EXPECT_TRUE(same(quick->a, twin.a) && same(quick->b, twin.b)) << text;
  return true;
}

std::string with_coordinate(const std::string& number) {
  return R"({"a":{"vertices":[[)" + number + R"(,0,1]]},"b":{"vertices":[[0,0,0]]}})";
}
std::string with_field(const std::string& field) {
  return "{" + field + R"(,"a":{"vertices":[[1,2,3]]},"b":{"vertices":[[0,0,0]]}})";
}
std::string with_a(const std::string& field) {
  return R"({"a":{"vertices":[[1,2,3]],)" + field + R"(},"b":{"vertices":[[0,0,0]]}})";
}

const std::vector<std::string> usual = {
    R"({"schema":"fathom/case/1","id":"two","a":{"vertices":[[0.5,-0.25,1e-3],[1,2,3]]},"b":{"vertices":[["1/3",0,-0]]}})",
    R"({"id": 7, "a": {"vertices": [[0, 0, 0]], "pose": [[1, 0, 0, "1/2"], [0, 1, 0, 0], [0, 0, 1, 2.5e10]]}, "b": {"vertices": [[1, 1, 1]]}})",
    R"({"a":{"vertices":[[1,2,3]],"pose":null,"pose_rounding":"binary64"},"b":{"pose_rounding":null,"vertices":[[4,5,6]]},"id":null})",
    R"( { "b" : { "vertices" : [ [ "0x1.8p3" , "12.5" , "-7" ] ] } , "pose_rounding" : "binary64" , "a" : { "vertices" : [ [ 1 , 2 , 3 ] ] } } )",
    R"({"flags":["deep","x\"\\\/\b\f\n\r\t"],"source":{"k":[1,{"v":true},null,false,-0.5e+7],"e":{},"l":[]},"a":{"vertices":[[1,2,3]],"more":"y"},"b":{"vertices":[[1,2,3]]}})",
    "{\n  \"id\": \"\u00e9\u4e2d\",\n  \"a\": {\"vertices\": [[1, 2, 3]]},\r\n\t\"b\": {\"vertices\": [[1, 2, "
    "3]]}\n}\n",
};

const std::vector<std::string> unusual = {
    "",
    " ",
    "{}",
    "[]",
    "3",
    "null",
    "\"id\"",
    R"({"a":{"vertices":[]},"b":{"vertices":[[0,0,0]]}})",
    R"({"a":{"vertices":[[0,0,0]]}})",
    R"({"a":3,"b":{"vertices":[[0,0,0]]}})",
    R"({"a":{},"b":{"vertices":[[0,0,0]]}})",
    R"({"a":{"vertices":[[0,0,0]]},"a":{"vertices":[[0,0,0]]},"b":{"vertices":[[0,0,0]]}})",
    R"({"a":{"vertices":[[0,0,0]]},"\u0061":{"vertices":[[0,0,0]]},"b":{"vertices":[[0,0,0]]}})",
    with_a(R"("vertices":[[1,2,3]])"),
    with_a(R"("pose":null,"pose":null)"),
    with_a(R"("pose":[])"),
    with_a(R"("pose":[[1,2,3,4],[1,2,3,4]])"),
    with_a(R"("pose":[[1,2,3,4],[1,2,3,4],[1,2,3,4],[1,2,3,4]])"),
    with_a(R"("pose":[[1,2,3,4],[1,2,3],[1,2,3,4]])"),
    with_a(R"("pose_rounding":"binary32")"),
    with_a(R"("x":"\ud800")"),
    with_a(R"("x":"\u00e9\n")"),
    with_a("\"x\":\"\xff\""),
    with_a("\"x\":\"\x01\""),
    with_field(R"("id":"a\"b")"),
    with_field(R"("id":true)"),
    with_field(R"("id":[])"),
    with_field(R"("id":-1)"),
    with_field(R"("id":1.50)"),
    with_field(R"("id":0)"),
    with_field(R"("id":00)"),
    with_field(R"("id":123456789012345678)"),
    with_field(R"("id":12345678901234567890123)"),
    with_field(R"("id":1e400)"),
    with_field(R"("id":"x","id":"y")"),
    with_field(R"("schema":null)"),
    with_field(R"("schema":"fathom/case/2")"),
    with_field(R"("schema":"fathom\/case\/1")"),
    with_field(R"("x":1e400)"),
    with_field(R"("x":01)"),
    with_field(R"("x":nul)"),
    with_field(R"("x":tru e)"),
    with_field(R"("x":"y"z)"),
    with_field(R"("x"y:1)"),
    with_field(R"("x":[1 2])"),
    with_field(R"("x":[1,])"),
    with_field(R"("x":{"y":1,})"),
    with_field(R"("x":{"y" 1})"),
    with_field(R"("x":{1:1})"),
    with_field(R"("x":[})"),
    with_field(R"("x":1,"x":2)"),
    with_field("\"x\":" + std::string(40, '[') + std::string(40, ']')),
    with_field("\"x\":" + std::string(70, '[') + std::string(70, ']')),
    with_field("\"x\":" + std::string(2000, '[')),
    with_coordinate("[1]"),
    with_coordinate("null"),
    with_coordinate("true"),
    with_coordinate("1,2"),
    with_coordinate("\"one\""),
    with_coordinate("\"1\\u002f2\""),
    with_coordinate("\"\""),
    with_coordinate("\"nan\""),
    "{} {}",
    usual[0] + "x",
    usual[0] + " " + usual[0],
    usual[0] + "\0"s,
    "\0"s + usual[0],
    "\xEF\xBB\xBF" + usual[0],
    usual[0] + "]",
    usual[0] + "}"};

TEST(QuickCaseFields, ReadsTheUsual) {
  for (const std::string& text : usual) EXPECT_TRUE(agree(text)) << text;
  std::ifstream file(FATHOM_TEST_DATA "/real_cases.jsonl");
  std::size_t lines = 0;
  for (std::string line; std::getline(file, line); ++lines) EXPECT_TRUE(agree(line)) << line;
  EXPECT_GT(lines, 10u);
}

TEST(QuickCaseFields, TheUnusualIsReadAsTheTwinReadsIt) {
  for (const std::string& text : unusual) agree(text);
  for (const char* refused :
       {"\"id\":\"x\",\"id\":\"y\"", "\"x\":1e400", "\"x\":[1,]", "\"x\":\"y\"z", "\"x\"y:1", "\"x\":01"})
    EXPECT_FALSE(agree(with_field(refused))) << refused;
}

TEST(QuickCaseFields, OneCharacterChanged) {
  const std::string characters = "{}[],:\"\\/0129.-+eEuxnt a\t\n\x01\x7f\xc3\xff"s + '\0';
  std::size_t read = 0, all = 0;
  for (const std::vector<std::string>* texts : {&usual, &unusual})
    for (const std::string& text : *texts) {
      if (text.size() > 400) continue;
      for (std::size_t i = 0; i < text.size(); ++i) {
        std::string shorter = text, twice = text;
        shorter.erase(i, 1);
        twice.insert(i, 1, text[i]);
        for (const std::string& changed : {text.substr(0, i), text.substr(i), shorter, twice})
          read += agree(changed), ++all;
        for (const char c : characters) {
          std::string other = text, longer = text;
          other[i] = c;
          longer.insert(i, 1, c);
          read += agree(other) + agree(longer);
          all += 2;
        }
      }
    }
  EXPECT_GT(read, 10000u) << "enough were read to compare";
  EXPECT_LT(read, all) << "enough were refused";
}

TEST(QuickCaseFields, Numbers) {
  std::vector<std::string> numbers =
      testing::words(R"(0 -0 0.0 -0.0 1 -1 9007199254740993 9007199254740992 18446744073709551615 18446744073709551616
      -9223372036854775809 123456789012345678901234567890 0.1 1e22 1e23 1E+5 5e-324 4.9e-324 2.4703282292062328e-324
      2.4703282292062327e-324 1e-400 -1e-400 2.2250738585072011e-308 2.2250738585072014e-308 1.7976931348623157e308
      1.7976931348623158e308 1.7976931348623159e308 0e999999 1e-999999999999999999999
      0.32283878326416015625000000000000000000000000001 0.12345678901234567890123
      9007199254740992.99999999999999999999 1e 1e+ .5 5. +5 0x10 1_0 1.5.5 --1 Infinity NaN - 1e5e5 1/2)");
  numbers.insert(numbers.end(), {"- 1", "1 2"});
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    std::string number = random() % 2 ? "-" : "";
    number += std::to_string(random() >> random() % 64);
    if (random() % 3 != 0) {
      number += '.';
      for (std::size_t digits = 1 + random() % 30; digits > 0; --digits)
        number += static_cast<char>('0' + random() % 10);
    }
    if (random() % 3 == 0) number += "e" + std::to_string(static_cast<int>(random() % 700) - 350);
    numbers.push_back(number);
  }
  for (int i = 0; i < 20000; ++i) {  // as programs print them, in a few characters more or less than 20
    char text[40];
    const double value =
        std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), static_cast<int>(random() % 200) - 150);
    std::snprintf(text, sizeof text, "%.*g", static_cast<int>(14 + random() % 6), value);
    numbers.emplace_back(text);
  }
  std::size_t read = 0;
  for (const std::string& number : numbers) read += agree(with_coordinate(number));
  EXPECT_GT(read, numbers.size() * 9 / 10);
}

TEST(QuickCaseFields, ALongCaseAfterShortOnes) {
  std::string points;
  for (int i = 0; i < 60000; ++i) points += (i == 0 ? "[" : ",[") + std::to_string(i) + ".25,-1.5e-7,\"1/7\"]";
  const std::string text = R"({"id":"long","a":{"vertices":[)" + points + R"(]},"b":{"vertices":[[0,0,0]]}})";
  ASSERT_GT(text.size(), std::size_t{1} << 20);
  EXPECT_TRUE(agree(usual[0]) && agree(text) && agree(usual[1]));
  EXPECT_FALSE(agree(text.substr(0, text.size() - 1)));
}

}  // namespace
}  // namespace fathom::files
