// SPDX-License-Identifier: GPL-3.0-or-later
// The reader and the writer of JSON against a library that knows nothing of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reference/text/json.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::text {
namespace {

using namespace std::string_literals;
using Library = nlohmann::json;

std::string by_library(const Library& value, int margin = -1) {
  return value.dump(margin, ' ', true, Library::error_handler_t::replace);
}

/// splitmix64.
struct Random {
  std::uint64_t state;
  std::uint64_t next() {
    std::uint64_t z = state += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return next() % n; }
};

/// Returns whether the text is JSON.
bool agree(const std::string& text) {
  const JsonRead read = read_json(text);
  const Library twin = Library::parse(text.substr(0, text.find('\0')), nullptr, false);
  EXPECT_EQ(read.whole, !twin.is_discarded()) << text;
  if (read.whole && !twin.is_discarded()) {
    // Of numbers that both read alike; some have several shortest texts.
    EXPECT_EQ(Library::parse(read.value.written().text()), twin) << text;
    EXPECT_EQ(Library::parse(read.value.written(JsonValue::Form::given).text()), twin) << text;
  }
  return read.whole;
}

const std::vector<std::string> texts = {
    R"({"a":[1,-2,0.5,1e3,-1.5E-7,true,false,null],"b":{"c":"\u00e9\ud83d\ude00\n\"\\\/","d":{}},"e":[]})",
    "[18446744073709551615,18446744073709551616,-9223372036854775808,-9223372036854775809,-0,1e-400,4.9e-324]",
    " \t\r\n[ [ ] , { } , \"\xc3\xa9\xf0\x9f\x98\x80\x7f\" ] \n",
    "\xEF\xBB\xBF{\"z\":1,\"a\":2}",
    R"({"same":1,"same":2})",
    "3",
    "\"text\""};

TEST(JsonRead, ReadsWhatALibraryReads) {
  for (const std::string& text : texts) EXPECT_TRUE(agree(text)) << text;
  for (const char* bad : {"",
                          "[",
                          "[1",
                          "[1,",
                          "[1,]",
                          "{",
                          "{\"a\"",
                          "{\"a\":",
                          "{\"a\":1,}",
                          "{1:2}",
                          "01",
                          "-",
                          "1.",
                          ".5",
                          "1e",
                          "+1",
                          "nul",
                          "truefalse",
                          "\"",
                          "\"\\x\"",
                          "\"\\u12\"",
                          "\"\\ud800\"",
                          "\"\\udc00\"",
                          "\"\\ud800\\u0041\"",
                          "\"\t\"",
                          "\"\xff\"",
                          "\"\xc0\x80\"",
                          "\"\xed\xa0\x80\"",
                          "\"\xf4\x90\x80\x80\"",
                          "\"\xe2\x82\"",
                          "1 2",
                          "[}",
                          "{]",
                          "1e400",
                          "-1e99999999999999999999"})
    EXPECT_FALSE(agree(bad)) << bad;
}

TEST(JsonRead, OneByteChanged) {
  const std::string bytes = "{}[],:\"\\/0129.-+eEuxnt a\t\n\x01\x7f\xc3\xff\xed\xa0"s;
  Random random{1};
  std::size_t whole = 0;
  for (int run = 0; run < 20'000; ++run) {
    std::string text = texts[random.below(texts.size())];
    const std::size_t at = random.below(text.size());
    if (random.below(3) == 0) text.erase(at, 1 + random.below(3));
    else if (random.below(2) == 0) text.insert(at, 1, bytes[random.below(bytes.size())]);
    else text[at] = bytes[random.below(bytes.size())];
    whole += agree(text) ? 1 : 0;
  }
  EXPECT_GT(whole, 1000u);
}

TEST(JsonRead, SaysWhereAndWhatWasExpected) {
  const auto fault = [](const std::string& text) {
    const JsonRead read = read_json(text);
    return std::to_string(read.error_at) + " " + read.error;
  };
  EXPECT_EQ(fault("[1 2]"), "3 expected ',' or ']', found '2'");
  EXPECT_EQ(fault("{\"a\" 1}"), "5 expected ':', found '1'");
  EXPECT_EQ(fault("{a:1}"), "1 expected a field's name in quotes, found 'a'");
  EXPECT_EQ(fault("{\"a\":1"), "6 expected ',' or '}', found the end");
  EXPECT_EQ(fault("[-inf]"), "2 expected a digit, found 'inf'");
  EXPECT_EQ(fault("\"\\q\""), "2 expected one of \"\\/bfnrtu behind a backslash, found 'q'");
  EXPECT_EQ(fault("\"a"), "2 expected '\"', found the end");
}

TEST(JsonRead, LeavesOutWhatIsTooDeep) {
  const std::string open(100'000, '['), close(100'000, ']');
  const JsonRead read = read_json(open + close);
  EXPECT_TRUE(read.whole);
  const JsonValue* value = &read.value;
  for (std::size_t i = 0; i < deepest_json; ++i) value = &value->at(0);
  EXPECT_TRUE(value->too_deep && value->items().empty());
  EXPECT_FALSE(read_json(open).whole);
}

TEST(JsonRead, TellsOfItsOwnPagesWhatIsMissing) {
  const JsonValue page = parsed_json(R"({"name":"x","count":18446744073709551615,"list":[true]})");
  EXPECT_EQ(page.at("name").string(), "x");
  EXPECT_EQ(page.at("count").natural(), 18446744073709551615u);
  EXPECT_TRUE(page.at("list").at(0).boolean());
  EXPECT_THROW((void)page.at("seed"), JsonFault);
  EXPECT_THROW((void)page.at("list").at(1), JsonFault);
  EXPECT_THROW((void)page.at("name").natural(), JsonFault);
  EXPECT_THROW((void)page.at("count").natural(7), JsonFault);
  EXPECT_THROW(parsed_json("{\"a\":}"), JsonFault);
}

TEST(JsonWritten, AsALibraryWritesIt) {
  Random random{2};
  for (int run = 0; run < 20'000; ++run) {
    std::string bytes(random.below(12), ' ');
    for (char& byte : bytes)
      byte = random.below(2) == 0 ? "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80\xed\xa0\xff\"\\"[random.below(15)]
                                  : static_cast<char>(random.next());
    EXPECT_EQ(Json(bytes).text(), by_library(bytes));
    EXPECT_EQ(valid_utf8(bytes), Library::parse(by_library(bytes)).get<std::string>());
  }
  std::size_t same = 0;
  const std::size_t runs = 20'000;
  for (std::size_t run = 0; run < runs; ++run) {
    const std::uint64_t bits = random.next();
    double number;
    std::memcpy(&number, &bits, sizeof number);
    if (run % 4 == 0)
      number = std::ldexp(static_cast<double>(random.below(100'000)), static_cast<int>(random.below(80)) - 40);
    const std::string text = Json(number).text();
    EXPECT_EQ(JsonStream().decimal(number).take(), text);
    same += text == by_library(number) ? 1 : 0;
    if (std::isfinite(number)) {
      EXPECT_EQ(Library::parse(text).get<double>(), number);
    }
    EXPECT_LE(text.size(), by_library(number).size()) << "law: no text is shorter";
  }
  EXPECT_GT(same, runs - runs / 50) << "that library's digits are not always the shortest";
}

TEST(JsonWritten, OnSeveralLines) {
  for (const std::string& text : texts) {
    if (text.find("e-4") != text.npos || text.find("E-7") != text.npos) continue;  // see above
    const Library twin = Library::parse(text);
    EXPECT_EQ(read_json(text).value.written().indented(), by_library(twin, 2));
  }
  EXPECT_EQ(Json({{"a\"[", Json::array({1, "]\\\"{"})}}).indented(),
            "{\n  \"a\\\"[\": [\n    1,\n    \"]\\\\\\\"{\"\n  ]\n}");
}

}  // namespace
}  // namespace fathom::text
