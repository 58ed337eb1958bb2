// SPDX-License-Identifier: GPL-3.0-or-later
// Cases and streams of cases: what numbers mean, what a pose does, where one case ends and the next
// begins.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "fathom/files.hpp"

namespace fathom::files {
namespace {

const std::string data = FATHOM_TEST_DATA "/";

/// A case with the one vertex `vertex` in A and whatever `more` adds to A.
std::string with_vertex(const std::string& vertex, const std::string& more = "", const std::string& rest = "") {
  return R"({"id":"x","a":{"vertices":[)" + vertex + "]" + more + R"(},"b":{"vertices":[[0,0,0]]})" + rest + "}";
}

Point first_vertex(const std::string& text) {
  const CaseItem item = parse_case(text, "c");
  if (!item.ok()) {
    ADD_FAILURE() << item.error().what();
    return {};
  }
  return item.value().a.points.exact().at(0);
}

std::vector<CaseItem> all(CaseStream stream) {
  std::vector<CaseItem> items;
  while (std::optional<CaseItem> item = stream.next()) items.push_back(*std::move(item));
  EXPECT_FALSE(stream.next().has_value()) << "the end stays the end";
  return items;
}

std::vector<CaseItem> all(const std::string& text) {
  std::istringstream input(text);
  return all(CaseStream(input, "c"));
}

/// "id" for good cases, "!id@line" for bad ones.
std::string outline(const std::vector<CaseItem>& items) {
  std::string text;
  for (const CaseItem& item : items)
    text += (text.empty() ? "" : " ") + (item.ok() ? item.id : "!" + item.id + "@" + std::to_string(item.line));
  return text;
}

TEST(Case, ANumberIsTheNearestBinary64) {
  EXPECT_EQ(first_vertex(with_vertex("[0.1,-1e-1,1E2]")), (Point{mpq_class(0.1), mpq_class(-0.1), 100}));
  EXPECT_EQ(first_vertex(with_vertex("[9007199254740993,-9007199254740993,9007199254740993.0]")),
            (Point{mpq_class("9007199254740992"), mpq_class("-9007199254740992"), mpq_class("9007199254740992")}));
  EXPECT_EQ(
      first_vertex(with_vertex("[9223372036854775807,18446744073709551615,-9223372036854775808]")),
      (Point{mpq_class("9223372036854775808"), mpq_class("18446744073709551616"), mpq_class("-9223372036854775808")}));
  EXPECT_EQ(first_vertex(with_vertex("[18446744073709551617,-100000000000000000000000,1e308]")),
            (Point{mpq_class("18446744073709551616"), mpq_class(-1e23), mpq_class(1e308)}));
  EXPECT_EQ(first_vertex(with_vertex("[-0,-0.0,1e-400]")), (Point{0, 0, 0}));
  EXPECT_EQ(first_vertex(with_vertex("[9007199254740992,5e-324,0.30000000000000004]")),
            (Point{mpq_class("9007199254740992"), mpq_class(5e-324), mpq_class(0.30000000000000004)}));
}

TEST(Case, AStringIsExact) {
  EXPECT_EQ(first_vertex(with_vertex(R"(["0.1","-22/7","0x1.8p-3"])")),
            (Point{mpq_class("1/10"), mpq_class("-22/7"), mpq_class("3/16")}));
  EXPECT_EQ(first_vertex(with_vertex(R"(["9007199254740993","1e400","\u0031e-400"])")),
            (Point{mpq_class("9007199254740993"), mpq_class("1" + std::string(400, '0')),
                   mpq_class("1/1" + std::string(400, '0'))}));
}

TEST(Case, PoseIsExact) {
  const std::string pose = R"(,"pose":[["3/5","-4/5",0,0.1],["4/5","3/5",0,"0.1"],[0,0,1,1]])";
  EXPECT_EQ(first_vertex(with_vertex("[1,2,3]", pose)), (Point{-1 + mpq_class(0.1), mpq_class("21/10"), 4}));
  EXPECT_EQ(
      first_vertex(R"({"a":{"pose":[[2,0,0,0],[0,2,0,0],[0,0,2,0]],"vertices":[[1,2,3]]},"b":{"vertices":[[0,0,0]]}})"),
      (Point{2, 4, 6}))
      << "the order of fields does not matter";
}

TEST(Case, PoseRoundingRoundsThePlacedVerticesOnce) {
  const std::string pose = R"(,"pose":[["1/3",0,0,0],[0,"1/3",0,"1e-30"],[0,0,1,0]])";
  const Point exact{mpq_class("1/3"), mpq_class("2/3") + mpq_class("1/1" + std::string(30, '0')), mpq_class("1/10")};
  const Point rounded{mpq_class(1.0 / 3), mpq_class(2.0 / 3), mpq_class(0.1)};
  EXPECT_EQ(first_vertex(with_vertex(R"([1,2,"1/10"])", pose)), exact);
  EXPECT_EQ(first_vertex(with_vertex(R"([1,2,"1/10"])", pose, R"(,"pose_rounding":"binary64")")), rounded);
  EXPECT_EQ(first_vertex(with_vertex(R"([1,2,"1/10"])", pose + R"(,"pose_rounding":"binary64")")), rounded);
  EXPECT_EQ(first_vertex(with_vertex(R"([1,2,"1/10"])", "", R"(,"pose_rounding":"binary64")")).z, mpq_class(0.1))
      << "without a pose too";
  const CaseItem item =
      parse_case(R"({"a":{"vertices":[["1/3",0,0]]},"b":{"vertices":[["1/3",0,0]],"pose_rounding":"binary64"}})", "c");
  EXPECT_EQ(item.value().a.points[0].x, mpq_class("1/3"));
  EXPECT_EQ(item.value().b.points[0].x, mpq_class(1.0 / 3));
}

TEST(Case, BothBodiesInOrder) {
  const CaseItem item = parse_case(
      R"({"schema":"fathom/case/1","b":{"vertices":[[7,8,9]]},"a":{"vertices":[[1,2,3],[4,5,6]]},"id":"n"})", "c", 5);
  ASSERT_TRUE(item.ok());
  EXPECT_EQ(item.line, 5u);
  EXPECT_EQ(item.id, "n");
  EXPECT_EQ(item.value().id, "n");
  EXPECT_EQ(item.value().a.points, (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(item.value().b.points, (std::vector<Point>{{7, 8, 9}}));
}

TEST(Case, IdIsTextANumberOrTheLine) {
  const auto id = [](const std::string& field) {
    return parse_case("{" + field + R"("a":{"vertices":[[1,2,3]]},"b":{"vertices":[[1,2,3]]}})", "c", 12).id;
  };
  EXPECT_EQ(id(""), "12");
  EXPECT_EQ(id(R"("id":null,)"), "12");
  EXPECT_EQ(id(R"("id":"\u00e4/..",)"), "\xc3\xa4/..");
  EXPECT_EQ(id(R"("id":"",)"), "");
  EXPECT_EQ(id(R"("id":17,)"), "17");
  EXPECT_EQ(id(R"("id":-17,)"), "-17");
  EXPECT_EQ(id(R"("id":18446744073709551615,)"), "18446744073709551615");
  EXPECT_EQ(id(R"("id":1.50,)"), "1.50");
}

TEST(Case, UnknownFieldsArePassedOver) {
  const std::string unknown =
      R"("flags":["a",{"vertices":[]}],"source":{"id":"no","a":{"vertices":3}},"x":[[[1],{}],null,true],"expected":{"pose":1},)";
  const CaseItem item = parse_case(
      "{" + unknown +
          R"("a":{"vertices":[[1,2,3]],"normals":[[0,1,2]],"a":{}},"comment":1e3,"b":{"vertices":[[1,2,3]],"c":"d"}})",
      "c");
  ASSERT_TRUE(item.ok()) << item.error().what();
  EXPECT_EQ(item.id, "1");
}

TEST(Case, NullStandsForAnOptionalFieldThatIsNotGiven) {
  EXPECT_EQ(first_vertex(with_vertex("[1,2,3]", R"(,"pose":null,"pose_rounding":null)",
                                     R"(,"pose_rounding":null,"flags":null)")),
            (Point{1, 2, 3}));
}

TEST(Case, NestingHasALimitThatTheCheckerSharesWhereverItStands) {
  const auto nested = [](std::size_t deep) { return std::string(deep, '[') + std::string(deep, ']'); };
  EXPECT_EQ(first_vertex(with_vertex("[1,2,3]", "", ",\"x\":" + nested(63))), (Point{1, 2, 3}));
  EXPECT_EQ(first_vertex(with_vertex("[1,2,3]", ",\"x\":" + nested(62))), (Point{1, 2, 3}));
  for (const std::string& text :
       {with_vertex("[1,2,3]", "", ",\"x\":" + nested(64)), with_vertex("[1,2,3]", ",\"x\":" + nested(63)),
        with_vertex("[1,2,3]", "", ",\"x\":" + nested(300'000))}) {
    const CaseItem item = parse_case(text, "c");
    ASSERT_FALSE(item.ok());
    EXPECT_STREQ(item.error().what(), "c:1: expected values nested at most 64 deep, found a deeper one");
    EXPECT_EQ(item.id, "x");
  }
  EXPECT_FALSE(parse_case(nested(300'000), "c").ok());
  EXPECT_FALSE(parse_case(std::string(300'000, '['), "c").ok());
  EXPECT_FALSE(parse_case(with_vertex(nested(300'000)), "c").ok());
}

TEST(CaseStream, OneALine) {
  const std::string x = with_vertex("[1,2,3]"),
                    anonymous = R"({"a":{"vertices":[[1,2,3]]},"b":{"vertices":[[0,0,0]]}})";
  EXPECT_EQ(outline(all(x + "\n" + anonymous + "\n")), "x 2");
  EXPECT_EQ(outline(all("\n \t\r\n" + x + "\r\n\n\n" + anonymous)), "x 6");
  EXPECT_EQ(outline(all("\xEF\xBB\xBF" + x)), "x");
}

TEST(CaseStream, ABadCaseDoesNotStopIt) {
  const std::string x = with_vertex("[1,2,3]");
  const std::string bad = R"({"a":{"vertices":[]},"b":{"vertices":[[0,0,0]]},"id":"bad"})";
  const std::vector<CaseItem> items =
      all(x + "\n" + x.substr(0, x.size() - 1) + "\nnoise\n{\n" + x + "\n" + bad + "\n[]\n" + x + "\n}\n" + x);
  EXPECT_EQ(outline(items), "x !x@2 !3@3 !4@4 x !bad@6 !7@7 x !9@9 x");
  for (const CaseItem& item : items)
    if (!item.ok()) {
      EXPECT_EQ(item.error().line(), item.line);
      EXPECT_EQ(item.error().file(), "c");
    }
}

TEST(CaseStream, PrettyPrintedCasesRunUntilTheirBracesBalance) {
  const std::string pretty =
      "{\n  \"id\": \"}{\\\"\",\n\n  \"a\": {\n    \"vertices\": [\n[1,2,3]]},\n\"b\": {\"vertices\": [[0, 0, 0]]\n  "
      "}\n}\n";
  const std::string x = with_vertex("[1,2,3]");
  EXPECT_EQ(outline(all(pretty)), "}{\"");
  EXPECT_EQ(outline(all(pretty + pretty + x + "\n\n" + pretty + x)), "}{\" }{\" x }{\" x");
  EXPECT_EQ(outline(all("{\n  \"id\": \"\\\"}\",\n" + x.substr(x.find("\"a\"")))), "\"}");
  EXPECT_EQ(outline(all("{\n  \"id\": \"cut\",\n" + x)), "!cut@1 x");
  EXPECT_EQ(outline(all("{\n  \"id\": \"cut\",\n  \"a\": {\n" + pretty)), "!cut@1 }{\"");
  const std::vector<CaseItem> items = all(x + "\n{\n  \"id\": \"y\",\n  \"a\": nought\n}\n" + x);
  EXPECT_EQ(outline(items), "x !y@2 x");
  EXPECT_EQ(items[1].error().line(), 4u) << "a syntax error names its own line";
}

/// Yields one character at a time and notes how far it was read.
class Watched : public std::streambuf {
 public:
  explicit Watched(std::string text) : text_(std::move(text)) {}
  [[nodiscard]] std::size_t taken() const { return taken_; }

 private:
  int_type underflow() override {
    if (taken_ == text_.size()) return traits_type::eof();
    setg(&text_[taken_], &text_[taken_], &text_[taken_] + 1);
    ++taken_;
    return traits_type::to_int_type(text_[taken_ - 1]);
  }
  std::string text_;
  std::size_t taken_ = 0;
};

TEST(CaseStream, ACaseIsYieldedBeforeTheNextLineIsRead) {
  const std::string x = with_vertex("[1,2,3]"), bad = "{\"id\": [";
  Watched buffer(x + "\n" + bad + "\n" + "{\n}\n" + x + "\n");
  std::istream input(&buffer);
  CaseStream stream(input, "c");
  std::size_t read = 0;
  for (const std::size_t length : {x.size() + 1, bad.size() + 1, std::size_t{4}, x.size() + 1}) {
    ASSERT_TRUE(stream.next().has_value());
    EXPECT_EQ(buffer.taken(), read += length);
  }
}

TEST(CaseStream, OpensFiles) {
  const auto open = [](const std::string& name) {
    std::istringstream unused;
    return all(CaseStream::open(data + name, unused));
  };
  const std::vector<CaseItem> posed = open("posed_boxes.json");
  ASSERT_EQ(outline(posed), "posed boxes");
  EXPECT_EQ(posed[0].value().b.points[1], (Point{mpq_class("3/2"), mpq_class("21/20"), mpq_class("3/4")}));
  const std::vector<CaseItem> real = open("real_cases.jsonl");
  ASSERT_EQ(real.size(), 63u);
  for (const CaseItem& item : real) EXPECT_TRUE(item.ok()) << item.error().what();
  EXPECT_EQ(real[0].id, "real::fcl-boxbox-regression1");
  EXPECT_EQ(real[0].value().a.points[0].x, mpq_class(0.6949997981776204));
}

TEST(CaseStream, DashIsStandardInput) {
  std::istringstream input(with_vertex("[1,2,3]") + "\nnoise\n");
  const std::vector<CaseItem> items = all(CaseStream::open("-", input));
  EXPECT_EQ(outline(items), "x !2@2");
  EXPECT_EQ(items[1].error().file(), "<stdin>");
}

class JsonFile : public testing::Test {
 protected:
  std::string outline_of(const std::string& name, const std::string& text) {
    const std::string path = (std::filesystem::temp_directory_path() / (std::to_string(getpid()) + name)).string();
    std::ofstream(path) << text;
    std::istringstream unused;
    const std::string result = outline(all(CaseStream::open(path, unused)));
    std::filesystem::remove(path);
    return result;
  }
};

TEST_F(JsonFile, IsOneCaseHoweverItIsBroken) {
  std::string broken;
  for (const char c : with_vertex("[1,2,3]"))
    broken += std::string(1, c) + (std::string("{}[]:,").find(c) != std::string::npos ? "\n" : "");
  EXPECT_EQ(outline_of(".json", broken), "x");
  EXPECT_EQ(outline_of(".JSON", "\n\n" + broken + "\n \n"), "x");
  EXPECT_EQ(outline_of(".json", broken.substr(0, broken.size() - 2)), "!x@1") << "cut short: one error";
  EXPECT_EQ(outline_of(".json", with_vertex("[1,2,3]") + "\n" + with_vertex("[1,2,3]") + "\n"), "x x")
      << "lines, whatever the name";
}

}  // namespace
}  // namespace fathom::files
