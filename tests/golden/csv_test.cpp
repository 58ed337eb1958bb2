// SPDX-License-Identifier: GPL-3.0-or-later
// The CSV says what the records say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/golden/some_recipes.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::json;

std::vector<Record> sample() {
  std::vector<Record> result;
  for (const Recipe& recipe :
       {Recipe{Source::family, "boxes_posed", 8, 5}, Recipe{Source::family, "solid_point", 4, 2},
        Recipe{Source::family, "touching_vertex_face", 4, 1}, Recipe{Source::family, "random_disjoint", 4, 1},
        Recipe{Source::family, "random_ball", 5, 2}}) {
    for (Record& record : records_of(recipe)) result.push_back(std::move(record));
  }
  return result;
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
    const std::string text = record.csv_row;
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

TEST(Csv, LeavesOutWhatIsNotBinary64) {
  const std::vector<Record> records = records_of({Source::family, "boxes_posed", 8, 5});
  ASSERT_EQ(records.size(), 3u);
  EXPECT_EQ(records[0].csv_row, "");
  for (const std::size_t i : {1U, 2U}) EXPECT_NE(records[i].csv_row, "");
}

TEST(Csv, WritesInfinity) {
  constexpr double largest = std::numeric_limits<double>::max();
  const Body box{GivenPoints(std::vector<std::array<double, 3>>{{-largest, -largest, -largest},
                                                                {largest, largest, largest},
                                                                {-largest, largest, largest},
                                                                {largest, -largest, largest},
                                                                {largest, largest, -largest},
                                                                {largest, -largest, -largest},
                                                                {-largest, largest, -largest},
                                                                {-largest, -largest, largest}})};
  const Record record = record_of({Source::family, "by_hand", 0, 0}, {Form::given, "by_hand", HullPair{box, box}});
  EXPECT_NE(record.csv_row.find(",inf,0x1.fffffffffffffp+1023,inf,"), std::string::npos);
}

}  // namespace
}  // namespace fathom::golden
