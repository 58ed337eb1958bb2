// SPDX-License-Identifier: GPL-3.0-or-later
// Cases and streams of cases: what numbers mean, what a pose does, where one case ends and the next
// begins.

#include "reference/files/cases.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <istream>
#include <limits>
#include <sstream>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "reference/files/file_io.hpp"
#include "tests/support/case_files.hpp"

namespace fathom::files {
namespace {

using testing::data;

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

std::vector<CaseItem> all(const std::string& text) {
  std::istringstream input(text);
  return testing::all(CaseStream(input, "c"));
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

TEST(Case, ATwistIsHowItsBodiesBeginToMove) {
  const auto motion = [](const std::string& twist) {
    return parse_case(R"({"a":{"vertices":[[1,2,3]]},"b":{"vertices":[[1,2,3]]})" + twist + "}", "c").value().motion;
  };
  EXPECT_FALSE(motion(""));
  const Motion both{{{1, mpq_class(1, 3), 0}, {0, 0, exact_value(0.1)}}, {{}, {-1, 0, 0}}};
  EXPECT_EQ(motion(R"(,"twist":{"b":{"w":[-1,0,0],"v":[0,0,0]},"a":{"v":[1,"1/3",0],"w":[0,0,0.1]}})"), both);
  EXPECT_EQ(motion(R"(,"twist":{"b":{"v":[0,0,0],"w":[-1,0,0]}})"), (Motion{{}, both.of_b}));
  const Case pair{"x", {{{1, 2, 3}}}, {{{1, 2, 3}}}, both};
  EXPECT_EQ(parse_case(files::case_json(pair), "c").value().motion, both) << "law: what is written is read";
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
    return testing::all(CaseStream::open(data + name, unused));
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
  const std::vector<CaseItem> items = testing::all(CaseStream::open("-", input));
  EXPECT_EQ(outline(items), "x !2@2");
  EXPECT_EQ(items[1].error().file(), "<stdin>");
}

class JsonFile : public ::testing::Test {
 protected:
  std::string outline_of(const std::string& name, const std::string& text) {
    const std::string path = (std::filesystem::temp_directory_path() / (std::to_string(getpid()) + name)).string();
    std::ofstream(path) << text;
    std::istringstream unused;
    const std::string result = outline(testing::all(CaseStream::open(path, unused)));
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

// Lines and cases beyond the limit of 256 MiB are refused and passed over; an input whose line has
// no end is given up.

/// Texts, each a number of times, from little memory.
class Generated : public std::streambuf {
 public:
  struct Piece {
    std::string text;
    std::size_t times = 1;
  };
  explicit Generated(std::vector<Piece> pieces) : pieces_(std::move(pieces)) {}

 private:
  int_type underflow() override {
    while (at_ < pieces_.size() && (pieces_[at_].times == 0 || pieces_[at_].text.empty())) ++at_;
    if (at_ == pieces_.size()) return traits_type::eof();
    std::string& text = pieces_[at_].text;
    --pieces_[at_].times;
    setg(text.data(), text.data(), text.data() + text.size());
    return traits_type::to_int_type(text[0]);
  }

  std::vector<Piece> pieces_;
  std::size_t at_ = 0;
};

const std::string good = R"({"id":"good","a":{"vertices":[[0,0,0]]},"b":{"vertices":[[0,0,0]]}})";

/// Of each case its id, or the sentence on what is wrong.
std::vector<std::string> outline(Generated& buffer) {
  std::istream input(&buffer);
  CaseStream stream(input, "c");
  std::vector<std::string> result;
  while (const std::optional<CaseItem> item = stream.next())
    result.push_back(item->ok() ? item->id : item->error().what());
  return result;
}

using Outline = std::vector<std::string>;

constexpr std::size_t block = std::size_t{1} << 16;

TEST(LongLines, ALineMayBeAsLongAsTheLimitAndNoLonger) {
  const Generated::Piece blanks{std::string(block, ' '), longest_line / block - 1};
  Generated most({{good}, blanks, {std::string(block - good.size(), ' ')}, {"\n" + good}});
  EXPECT_EQ(outline(most), (Outline{"good", "good"}));
  Generated more({{good}, blanks, {std::string(block - good.size() + 1, ' ')}, {"\n" + good}});
  EXPECT_EQ(outline(more), (Outline{"c:1: expected a case of at most 256 MiB, found a longer one", "good"}));
}

TEST(LongLines, ACaseOfManyLinesHasTheSameLimit) {
  const Generated::Piece line{" \"x\": [\"" + std::string(block, 'x') + "\"],\n", longest_line / block};
  Generated buffer({{"\n\n{\n"}, line, {good.substr(1) + "\n" + good}});
  EXPECT_EQ(outline(buffer), (Outline{"c:3: expected a case of at most 256 MiB, found a longer one", "good"}));
}

TEST(LongLines, OneWithoutAnEnd) {
  Generated buffer({{std::string(block, '\0'), std::numeric_limits<std::size_t>::max()}});
  EXPECT_EQ(outline(buffer), Outline{"c:1: expected a case of at most 256 MiB, found one without an end"});
}

// The texts are in the two spellings of FCL: 0.6 and 0.7, and what followed.

const std::string old_boxes =
    "terminate called after throwing an instance of 'std::logic_error'\n"
    "  what():  Error with configuration\n"
    "  Original error message: gjk_libccd-inl.h:(1715): validate(): The origin is outside.\n"
    "  Shape 1: Box0.5 1 2\n"
    "  X_FS1\n"
    " 0.96193976625564348026  0.15401279915737359216  0.22572537250328919556   2.0770063995786869349\n"
    "-0.19134171618254486313  0.96936494951283913579  0.15401279915737359216                    -3.5\n"
    "                      0                       0                       1                   1e-3\n"
    "                      0                       0                       0                       1\n"
    "  Shape 2: Box0.10000000000000000555   0.3499999999999999778   1.8449999999999999734\n"
    "  X_FS2\n"
    "1 0 0 2\n0 1 0 0\n0 0 1 1.25\n0 0 0 1\n"
    "  Solver: GjkSolver_libccd\n"
    "    collision_tolerance:      2.0097183471152322134e-14\n";

const std::string new_prism =
    "  Shape 1:\n"
    "Convex<double>(\n"
    "  std::make_shared<std::vector<Vector3<double>>>(\n"
    "    std::initializer_list<Vector3<double>>{\n"
    "      Vector3<double>(0.5, 0.5, -0.86602500000000004476),\n"
    "      Vector3<double>(0.5, -0.5, 0), Vector3<double>(1, 2, 3),\n"
    "      Vector3<double>(-1, 0, 0)}),\n"
    "  4,\n"
    "  std::make_shared<std::vector<int>>(\n"
    "    std::initializer_list<int>{\n"
    "      3, 0, 1, 2,\n"
    "      3, 0, 2, 3}),\n"
    "  false);\n"
    "  X_FS1\n"
    "1, 0, 0, 12,\n0, 1, 0, 13,\n0, 0, 1, 14,\n0, 0, 0, 1;\n"
    "  Shape 2:\n"
    "Box<double>(1, 2, 3);\n"
    "  X_FS2\n"
    "1, 0, 0, 17,\n0, 1, 0, 18,\n0, 0, 1, 19,\n0, 0, 0, 1;\n"
    "  Solver: GjkSolver_libccd\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string refusal(const std::string& text) {
  try {
    read_fcl_text(text, "log");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FclText, OfBoxesInTheOldSpelling) {
  const std::vector<FclFailure> failures = read_fcl_text(old_boxes, "log");
  ASSERT_EQ(failures.size(), 1u);
  const FclFailure& failure = failures[0];
  EXPECT_EQ(failure.line, 4u);
  EXPECT_EQ(failure.message, "gjk_libccd-inl.h:(1715): validate(): The origin is outside.");
  ASSERT_EQ(failure.first.body.points.size(), 8u);
  EXPECT_EQ(failure.first.body.points[0], (Point{mpq_class(-1, 4), mpq_class(-1, 2), -1}));
  EXPECT_EQ(failure.first.body.points[7], (Point{mpq_class(1, 4), mpq_class(1, 2), 1}));
  EXPECT_EQ(failure.first.pose[0][1], mpq_class(0.15401279915737359216));
  EXPECT_EQ(failure.first.pose[1][3], mpq_class(-7, 2));
  EXPECT_EQ(failure.first.pose[2][3], mpq_class(1e-3));
  EXPECT_EQ(failure.second.body.points[1].x, mpq_class(0.1) / 2);
  EXPECT_EQ(failure.second.pose[2][3], mpq_class(5, 4));
}

TEST(FclText, OfAConvexInTheNewSpelling) {
  const std::vector<FclFailure> failures = read_fcl_text(new_prism, "log");
  ASSERT_EQ(failures.size(), 1u);
  const std::vector<Point>& points = failures[0].first.body.points;
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[0], (Point{mpq_class(1, 2), mpq_class(1, 2), mpq_class(-0.86602500000000004476)}));
  EXPECT_EQ(points[2], (Point{1, 2, 3}));
  EXPECT_EQ(points[3], (Point{-1, 0, 0}));
  EXPECT_EQ(failures[0].second.body.points[7], (Point{mpq_class(1, 2), 1, mpq_class(3, 2)}));
  EXPECT_EQ(failures[0].second.pose[0][3], 17);
  EXPECT_EQ(failures[0].message, "");
}

TEST(FclText, SeveralInALogWhoseLinesHaveAPrefix) {
  std::string log = "other words\n";
  for (const std::string& text : {old_boxes, new_prism}) {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = text.find('\n', begin);
      log += "[12:00] " + text.substr(begin, end - begin) + "\r\n";
      begin = end + 1;
    }
  }
  const std::vector<FclFailure> failures = read_fcl_text(log, "log");
  ASSERT_EQ(failures.size(), 2u);
  EXPECT_EQ(failures[0].second.pose[2][3], mpq_class(5, 4));
  EXPECT_EQ(failures[1].first.body.points.size(), 4u);
  EXPECT_EQ(failures[1].message, "");
}

TEST(FclText, IsRefusedWithItsLine) {
  const auto expects = [](const std::string& text, const std::string& words) {
    const std::string said = refusal(text);
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  expects("", "expected the text of an exception of FCL");
  expects(replaced(new_prism, "Box<double>(1, 2, 3)", "Sphere<double>(1.5)"),
          "log:20: expected a Box or a Convex (other shapes are not polytopes)");
  expects(replaced(old_boxes, "Box0.5 1 2", "Convex(v count: 8, f count: 6)"),
          "log:4: expected a Convex with its points");
  expects(replaced(old_boxes, "Box0.5 1 2", "Box0.5 1"), "log:4: expected the three sides of a Box");
  expects(replaced(old_boxes, "Box0.5 1 2", "Box0.5 1 2 3"), "log:4: expected the three sides of a Box");
  expects(replaced(old_boxes, "Box0.5 1 2", "Box0.5 -1 2"), "none negative");
  expects(replaced(old_boxes, "Box0.5 1 2", "Box0.5 nan 2"), "log:4: expected the three sides");
  expects(replaced(old_boxes, "-3.5", "inf"), "log:7: expected number 8 of a 4 x 4 matrix, found 'inf'");
  expects(replaced(old_boxes, "-3.5", "1e400"), "log:7: expected number 8");
  expects(replaced(old_boxes, "0 0 0 1", "0 0 0 2"), "log:15: expected a last row of 0 0 0 1");
  expects(replaced(old_boxes, "0 0 0 1", "0 0 0 1 1"), "log:15: expected the end of a 4 x 4 matrix, found '1'");
  expects(replaced(old_boxes, "  X_FS1\n", ""), "log:5: expected X_FS1");
  expects(replaced(old_boxes, "Shape 2", "Shape 3"), "log:10: expected 'Shape 2:'");
  expects(replaced(new_prism, "(1, 2, 3),", "(1, 2),"), "log:6: expected the three coordinates of a point");
  expects(replaced(new_prism, "Vector3<double>(1, 2, 3)", "Vector3<double>(1, 2, x)"),
          "log:6: expected the three coordinates");
}

TEST(FclText, AnyPrefixOfItIsReadOrRefused) {
  for (const std::string& text : {old_boxes, new_prism})
    for (std::size_t length = 0; length < text.size(); ++length) {
      const std::string said = refusal(text.substr(0, length));
      EXPECT_TRUE(said.empty() || said.find("expected") != std::string::npos) << said;
    }
  EXPECT_NE(refusal(new_prism.substr(0, new_prism.find("19,"))), "");
}

}  // namespace
}  // namespace fathom::files
