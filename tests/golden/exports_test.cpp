// SPDX-License-Identifier: GPL-3.0-or-later
// The exports say what the records say, as other programs read them: this one includes a C++ export as it was compiled in.
#include "verify/golden/records/exports.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/golden/some_recipes.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::json;

/// As the head of an include file tells its users to.
struct GoldenCase {
  const char *id, *status;
  double depth, depth_down, depth_up;
  std::array<double, 3> direction, translation;
  int optima;
  double distance;
  std::vector<std::array<double, 3>> a, b;
};

std::vector<GoldenCase> compiled_in() {
  std::vector<GoldenCase> cases;
#define FATHOM_GOLDEN_CASE(...) cases.push_back(GoldenCase{__VA_ARGS__});
#include "tests/golden/sample.inc"
  return cases;
}

/// What sample.inc holds.
std::vector<Record> sample() {
  std::vector<Record> result;
  for (const Recipe& recipe : {Recipe{Source::family, "boxes_posed", 8, 5}, Recipe{Source::family, "solid_point", 4, 2},
                               Recipe{Source::family, "touching_vertex_face", 4, 1}, Recipe{Source::family, "random_disjoint", 4, 1},
                               Recipe{Source::family, "random_ball", 5, 2}}) {
    for (Record& record : records_of(recipe)) result.push_back(std::move(record));
  }
  return result;
}

TEST(Include, IsWhatTheSampleHolds) {
  std::string text = include_head();
  for (const Record& record : sample()) text += record.exports.include_entry;
  text += include_tail();
  std::ifstream file(FATHOM_TEST_DATA "/../golden/sample.inc");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), text);
}

double support(const std::vector<std::array<double, 3>>& points, const std::array<double, 3>& u, double sense) {
  double best = -HUGE_VAL;
  for (const auto& p : points) best = std::max(best, sense * (u[0] * p[0] + u[1] * p[1] + u[2] * p[2]));
  return best;
}

TEST(Include, CompilesAndJudgesACase) {
  const std::vector<GoldenCase> cases = compiled_in();
  ASSERT_GE(cases.size(), 5u);
  std::vector<std::string> statuses;
  for (const GoldenCase& golden : cases) {
    // h(u) is the depth along u: penetrating, it is the least of all, and -distance when the bodies are apart.
    const double along = support(golden.b, golden.direction, 1) + support(golden.a, golden.direction, -1);
    const double signed_depth = golden.depth - golden.distance;
    EXPECT_NEAR(along, signed_depth, 1e-12) << golden.id;
    EXPECT_LE(golden.depth_down, golden.depth);
    EXPECT_GE(golden.depth_up, golden.depth);
    EXPECT_LE(golden.depth_up, std::nextafter(golden.depth_down, HUGE_VAL));
    const auto& t = golden.translation;
    EXPECT_NEAR(std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]), std::abs(signed_depth), 1e-12) << golden.id;
    EXPECT_EQ(golden.optima > 0, golden.depth > 0) << golden.id;
    statuses.emplace_back(golden.status);
  }
  for (const char* status : {"penetrating", "touching", "disjoint"})
    EXPECT_NE(std::ranges::find(statuses, status), statuses.end()) << status;
}

std::vector<std::string> fields(const std::string& row) {
  EXPECT_TRUE(row.ends_with('\n'));
  std::vector<std::string> result{""};
  for (const char c : row.substr(0, row.size() - 1)) {
    if (c == ',') result.emplace_back();
    else result.back() += c;
  }
  return result;
}

TEST(Csv, RowsHaveTheColumnsOfTheHeader) {
  const std::vector<std::string> header = fields(csv_header());
  const auto column = [&header](const std::vector<std::string>& row, const std::string& name) {
    const auto at = std::ranges::find(header, name);
    EXPECT_NE(at, header.end()) << name;
    return row[static_cast<std::size_t>(at - header.begin())];
  };
  for (const Record& record : sample()) {
    const std::string text = record.exports.csv_row;
    ASSERT_EQ(!text.empty(), record.in_binary64) << record.id;
    if (text.empty()) continue;
    const std::vector<std::string> row = fields(text);
    ASSERT_EQ(row.size(), header.size()) << record.id;
    const Json parsed = Json::parse(record.line);
    const Json& expected = parsed["expected"];
    EXPECT_EQ(column(row, "id"), record.id);
    EXPECT_EQ(column(row, "status"), expected["status"]);
    EXPECT_EQ(column(row, "format"), record.in_binary32 ? "binary32" : "binary64");
    EXPECT_EQ(column(row, "depth_squared"), expected["depth"]["squared"]);
    EXPECT_EQ(column(row, "depth_f64_ru"), expected["depth"]["f64"]["ru"]);
    EXPECT_EQ(column(row, "depth_f32_rd"), expected["depth"]["f32"]["rd"]);
    EXPECT_EQ(column(row, "optima"), std::to_string(expected["optima"].size()));
    EXPECT_EQ(column(row, "a_count"), std::to_string(parsed["a"]["vertices"].size()));
    std::istringstream points(column(row, "b_points"));
    for (const Json& vertex : parsed["b"]["vertices"]) {
      for (const Json& coordinate : vertex) {
        std::string hex;
        points >> hex;
        EXPECT_EQ(hex, coordinate) << record.id;
      }
    }
    std::string more;
    EXPECT_FALSE(points >> more);
  }
}

TEST(Exports, LeaveOutWhatIsNotBinary64) {
  const std::vector<Record> records = records_of({Source::family, "boxes_posed", 8, 5});
  ASSERT_EQ(records.size(), 3u);
  EXPECT_EQ(records[0].exports.csv_row, "");
  EXPECT_EQ(records[0].exports.include_entry, "");
  for (const std::size_t i : {1U, 2U}) {
    EXPECT_NE(records[i].exports.csv_row, "");
    EXPECT_NE(records[i].exports.include_entry, "");
  }
}

TEST(Include, WritesInfinityAsCpp) {
  constexpr double largest = std::numeric_limits<double>::max();
  const Body box{GivenPoints(std::vector<std::array<double, 3>>{{-largest, -largest, -largest},
                                                                {largest, largest, largest},
                                                                {-largest, largest, largest},
                                                                {largest, -largest, largest},
                                                                {largest, largest, -largest},
                                                                {largest, -largest, -largest},
                                                                {-largest, largest, -largest},
                                                                {-largest, -largest, largest}})};
  const Record record = record_of({Source::family, "by_hand", 0, 0}, Form::given, {"by_hand", box, box});
  const std::string infinity = "std::numeric_limits<double>::infinity()";
  EXPECT_NE(record.exports.include_entry.find("\"penetrating\", " + infinity + ", 0x1.fffffffffffffp+1023, " + infinity + ", {"),
            std::string::npos)
      << record.exports.include_entry;
  EXPECT_NE(record.exports.include_entry.find("-" + infinity), std::string::npos) << "of a translation";
  EXPECT_NE(record.exports.csv_row.find(",inf,0x1.fffffffffffffp+1023,inf,"), std::string::npos);
}

}  // namespace
}  // namespace fathom::golden
