// SPDX-License-Identifier: GPL-3.0-or-later
// 63 pairs from the issue trackers and test suites of collision libraries, with exact answers that two independent programs found.
// Sources, and what four libraries answered, stand in tests/data/real_cases.jsonl.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "fathom/depth.hpp"
#include "fathom/files.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::depth {
namespace {

// As the file has them: exact strings, in lexicographic order of the strings.
std::vector<std::vector<std::string>> translations(const Depth& depth) {
  if (depth.optima().empty()) return {{"0", "0", "0"}};
  std::vector<std::vector<std::string>> result;
  for (const Optimum& o : depth.optima()) {
    const Point t = o.translation();
    result.push_back({t.x.get_str(), t.y.get_str(), t.z.get_str()});
  }
  std::ranges::sort(result);
  return result;
}

TEST(RealCases, HaveTheStatedAnswers) {
  std::ifstream file(FATHOM_TEST_DATA "/real_cases.jsonl");
  ASSERT_TRUE(file);
  std::size_t cases = 0;
  for (std::string line; std::getline(file, line); ++cases) {
    const CaseItem item = parse_case(line, "real_cases.jsonl", cases + 1);
    ASSERT_TRUE(item.ok()) << item.error().what();
    const Case& input = item.value();
    const nlohmann::json expected = nlohmann::json::parse(line)["expected"];
    const Depth depth = testing::exact_depth(input.a.points, input.b.points, {.validate = true});
    EXPECT_EQ(name(depth.status()), expected["status"]) << item.id;
    EXPECT_EQ(depth.squared().get_str(), expected["depth_squared"]) << item.id;
    std::vector<std::vector<std::string>> stated = expected["translations"];
    std::ranges::sort(stated);
    EXPECT_EQ(translations(depth), stated) << item.id;
    const kernels::Report report = testing::check(depth, input.a.points, input.b.points);
    EXPECT_TRUE(report.ok()) << item.id << "\n" << testing::text(report);
    EXPECT_EQ(fathom::penetration_depth(input.a.points, input.b.points, {.method = Method::naive}).optima(), depth.optima()) << item.id;
  }
  EXPECT_EQ(cases, 63U);
}

}  // namespace
}  // namespace fathom::depth
