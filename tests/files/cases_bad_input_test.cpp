// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of bad case gets its sentence: what was expected, where in the object, what was found.
// Cut and noisy text is refused.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fathom/files.hpp"
#include "tests/support/case_files.hpp"
#include "tests/support/property.hpp"
#include "tests/support/words.hpp"

namespace fathom::files {
namespace {

const std::string good_b = R"("b":{"vertices":[[0,0,0]]})";

/// What is said of a case, without "c:1: "; empty if it is taken.
std::string complaint(const std::string& text) {
  const CaseItem item = parse_case(text, "c");
  if (item.ok()) return "";
  const std::string sentence = item.error().what();
  EXPECT_TRUE(sentence.starts_with("c:1: ")) << sentence;
  return sentence.substr(5);
}
std::string of_a(const std::string& a) { return complaint("{\"a\":" + a + "," + good_b + "}"); }
std::string of_vertices(const std::string& vertices) { return of_a("{\"vertices\":" + vertices + "}"); }

/// Rows of a text and the sentence, which is empty for what is taken.
TEST(BadCase, EachTextHasItsSentence) {
  std::ifstream file(FATHOM_TEST_DATA "/bad_cases.jsonl");
  std::size_t rows = 0;
  for (std::string line; std::getline(file, line); ++rows) {
    const nlohmann::json row = nlohmann::json::parse(line);
    EXPECT_EQ(complaint(row["text"]), row["says"].get<std::string>()) << row["text"];
  }
  EXPECT_GE(rows, 54U);
}

TEST(BadCase, FieldsOfAnotherBody) {
  const std::string at_a = "a.", found = ", found one";
  for (const auto& [field, value] : {std::pair("radius", "5"), std::pair("half_length", "1"),
                                     std::pair("half", "[1,1,1]"), std::pair("radii", "[1,1,1]"),
                                     std::pair("offset", "0"), std::pair("axis", "\"x\""), std::pair("terms", "[]")}) {
    const std::string more = ",\"" + std::string(field) + "\":" + value + "}";
    const std::string expected = at_a + field + ": expected no such field";
    EXPECT_EQ(of_a(R"({"vertices":[[0,0,0]])" + more), expected + " of a hull" + found);
    EXPECT_EQ(of_a(R"({"shape":"hull","vertices":[[0,0,0]])" + more), expected + " of a hull" + found);
    EXPECT_EQ(of_a(R"({"margin":0,"vertices":[[0,0,0]])" + more), expected + " of a hull" + found);
    EXPECT_EQ(of_a(R"({"pieces":[{"shape":"box","half":[1,1,1]}])" + more), expected + " beside 'pieces'" + found);
    EXPECT_EQ(of_a(R"({"pieces":[{"vertices":[[0,0,0]])" + more + "]}"),
              "a.pieces[0]." + expected.substr(2) + " of a hull" + found);
    EXPECT_EQ(of_a(R"({"vertices":[[0,0,0]],")" + std::string(field) + R"(":null})"), "") << "law: null is no field";
  }
  EXPECT_EQ(of_a(R"({"shape":"sphere","radius":1,"pieces":null,"name":"ball","terms":null})"), "")
      << "law: unknown fields are passed over";
}

TEST(BadCase, FacesOfPieces) {
  const auto of_piece = [](const std::string& faces) {
    return of_a(R"({"pieces":[{"vertices":[[0,0,0],[1,0,0],[0,1,0]],"faces":)" + faces + "}]}");
  };
  EXPECT_EQ(of_piece("[[0,1,2]]"), "");
  EXPECT_EQ(of_piece("null"), "");
  EXPECT_EQ(of_piece("[[0,1,3]]"), "a.pieces[0].faces[0]: expected vertex indices below 3, found 3");
}

TEST(BadCase, Vertices) {
  EXPECT_EQ(
      of_vertices("[[0,-" + std::string(400, '9') + ",0]]"),
      "a.vertices[0][1]: expected a number within the range of binary64, found '-" + std::string(39, '9') + "...'");
}

TEST(BadCase, Pose) {
  EXPECT_EQ(of_a(R"({"vertices":[[0,0,0],[10,0,0]],"pose":[[1e308,0,0,0],[0,1,0,0],[0,0,1,0]]})"), "")
      << "exact: no bound";
}

TEST(BadCase, Syntax) {
  for (const char* number : {"Infinity", "-Infinity", ".5", "1.", "+1", "01", "0x10", "1e", "--1", "1/2"})
    EXPECT_TRUE(of_vertices(std::string("[[0,") + number + ",0]]")
                    .starts_with("expected JSON, found a syntax error at column "))
        << number;
  EXPECT_TRUE(complaint("{\"id\":\"\xff\"}")
                  .starts_with("expected JSON, found a syntax error at column 8: expected UTF-8, found "));
  EXPECT_STREQ(parse_case("{\"a\":\n1,}", "c").error().what(),
               "c:2: expected JSON, found a syntax error at column 3: expected a field's name in quotes, found '}'");
  const std::string sentence = complaint("{\"id\":\"" + std::string(1000, 'x'));
  EXPECT_LT(sentence.size(), 300u);
}

TEST(BadCase, NothingButWhiteSpaceBehindTheObject) {
  using namespace std::string_literals;
  const std::string good = "{\"a\":{\"vertices\":[[0,0,0]]}," + good_b + "}";
  const std::string column = std::to_string(good.size() + 1);
  EXPECT_EQ(complaint(good + " \t\r\n"), "");
  for (const std::string& junk : {"\0"s, "\0junk"s, "\0{}"s, "\0\n"s})
    EXPECT_EQ(complaint(good + junk), "expected JSON, found a null byte at column " + column);
  const CaseItem item = parse_case("{\"id\":\"x\",\n\0"s + good.substr(1), "c", 7);
  ASSERT_FALSE(item.ok());
  EXPECT_STREQ(item.error().what(), "c:8: expected JSON, found a null byte at column 1");
  EXPECT_EQ(item.id, "x");
}

// One look at each would take hours if every repetition were compared with all before it.
TEST(BadCase, AMillionRepetitionsOfAField) {
  std::string text = "{";
  for (const char* field : {"\"a\":0,", "\"b\":0,"})
    for (int i = 0; i < 1'000'000; ++i) text += field;
  EXPECT_EQ(complaint(text + good_b + "}"),
            "a: expected an object with 'vertices', 'shape', 'pieces' or 'solid', found 0");
}

TEST(BadCase, TheIdIsToldWhereverItStands) {
  EXPECT_EQ(parse_case(R"({"a":3,"id":"late"})", "c").id, "late");
  EXPECT_EQ(parse_case(R"({"id":"early","a":)", "c").id, "early");
  EXPECT_EQ(parse_case(R"({"a":{"id":"not this"},"id")", "c", 9).id, "9");
}

TEST(BadStream, NothingAtAll) {
  for (const char* text : {"", "\n", " \n\t\r\n"}) {
    std::istringstream input(text);
    const std::vector<CaseItem> items = testing::all(CaseStream(input, "c"));
    ASSERT_EQ(items.size(), 1u);
    EXPECT_STREQ(items[0].error().what(), "c:1: expected at least one case, found an empty input");
  }
}

TEST(BadStream, ReadingFails) {
  struct Failing : std::streambuf {
    int_type underflow() override { throw std::runtime_error("no more"); }
  } buffer;
  std::istream input(&buffer);
  const std::vector<CaseItem> items = testing::all(CaseStream(input, "c"));
  ASSERT_EQ(items.size(), 1u);
  EXPECT_STREQ(items[0].error().what(), "c:1: expected a line, found that the input cannot be read further");
}

TEST(BadStream, CannotBeOpened) {
  const auto complaint_of = [](const std::string& path) -> std::string {
    std::istringstream unused;
    try {
      CaseStream::open(path, unused);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(complaint_of(folder), folder + ": expected a readable file, found a directory");
  EXPECT_EQ(complaint_of(folder + "/no.jsonl"),
            folder + "/no.jsonl: expected a readable file, found none of this name");
  EXPECT_EQ(complaint_of(folder + "/no.json"), folder + "/no.json: expected a readable file, found none of this name");
}

const std::string rich =
    R"({"schema":"fathom/case/1","id":"x\u00e4","a":{"vertices":[[0.5,-1e2,"1/3"],["0x1p-2",7,0]],"pose":[[1,0,0,"0.1"],[0,1,0,0],)"
    R"([0,0,1,-2]]},"b":{"vertices":[[0,0,0]],"pose_rounding":"binary64"},"flags":["f"],"source":{"n":null,"t":[true,false]}})";

TEST(Truncation, EveryPrefixOfACaseIsRefused) {
  ASSERT_EQ(complaint(rich), "");
  for (std::size_t length = 0; length < rich.size(); ++length)
    EXPECT_NE(complaint(rich.substr(0, length)), "") << length;
}

TEST(Truncation, EveryPrefixOfAStream) {
  const std::string text =
      rich + "\n{\n \"id\": 3,\n \"a\": {\"vertices\": [[1, 2, 3]]},\n \"b\":\n {\"vertices\": [[1, 2, 3]]}\n}\n" +
      rich + "\n";
  for (std::size_t length = 0; length <= text.size(); ++length) {
    std::istringstream input(text.substr(0, length));
    std::size_t good = 0;
    const std::vector<CaseItem> items = testing::all(CaseStream(input, "c"));
    for (const CaseItem& item : items) good += item.ok() ? 1 : 0;
    EXPECT_TRUE(!items.empty() && items.size() <= 3 && good + 1 >= items.size()) << length;
    EXPECT_TRUE(length < text.size() || good == 3);
  }
}

/// Every outcome is a well-formed case or a sentence in printable ASCII.
void expect_sound(const std::string& text) {
  std::istringstream input(text);
  const std::vector<CaseItem> items = testing::all(CaseStream(input, "c"));
  EXPECT_FALSE(items.empty());
  for (const CaseItem& item : items) {
    if (item.ok()) {
      EXPECT_FALSE(item.value().a.points.empty() || item.value().b.points.empty());
    } else {
      for (const char c : std::string(item.error().what())) EXPECT_TRUE(c >= 0x20 && c < 0x7f) << item.error().what();
    }
  }
}

TEST(Noise, BytesChanged) {
  EXPECT_TRUE(holds({.seed = 13, .runs = 5000, .max_size = 200}, [] {
    std::string text = rich;
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i)
      text[*rc::gen::inRange<std::size_t>(0, text.size())] = static_cast<char>(*rc::gen::inRange(0, 256));
    expect_sound(text);
  }));
}

TEST(Noise, TokensOfCasesThatNearlyFit) {
  std::vector<std::string> tokens = testing::words(
      R"({ } [ ] : , "a" "b" "vertices" "pose" "id" "schema" "pose_rounding" "binary64" 1 -2.5 1e400 null true "1/3"
      {"vertices":[[1,2,3]]} [1,2,3] " \ {"a":)");
  tokens.insert(tokens.end(), {"\n", "{\n", "\xff"});
  EXPECT_TRUE(holds({.seed = 8, .runs = 3000, .max_size = 300}, [&] {
    std::string text;
    for (const std::string& token : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(tokens)))
      text += token;
    expect_sound(text);
  }));
}

}  // namespace
}  // namespace fathom::files
