// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs from issue trackers and test suites: 63 of collision libraries, with answers that two
// independent programs found, and 141 of public reports of all who need depths and distances.
// Sources stand in tests/data/real_cases.jsonl and report_cases.jsonl.
#include <gtest/gtest.h>

#include "fathom/depth.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/stated_cases.hpp"

namespace fathom::depth {
namespace {

using Json = nlohmann::json;
using testing::stated_cases;

Json translations(const Depth& depth) {
  std::vector<Point> result;
  for (const Optimum& o : depth.optima()) result.push_back(o.translation());
  return testing::translation_texts(result);
}

TEST(RealCases, OfPointsHaveTheStatedAnswers) {
  std::size_t cases = 0;
  for (const auto& [pair, line, answer] : stated_cases()) {
    const std::vector<Point>&a = pair.a.points, &b = pair.b.points;
    if (a.empty() || b.empty()) continue;
    SCOPED_TRACE(pair.id);
    const Depth depth = testing::exact_depth(a, b, {.validate = true});
    EXPECT_EQ(name(depth.status()), answer["status"]);
    EXPECT_EQ(depth.squared().get_str(), answer["depth_squared"]);
    EXPECT_EQ(translations(depth), answer["translations"]);
    const kernels::Report report = testing::check(depth, a, b);
    EXPECT_TRUE(report.ok()) << testing::text(report);
    EXPECT_EQ(fathom::penetration_depth(a, b, {.method = Method::naive}).optima(), depth.optima());
    ++cases;
  }
  EXPECT_EQ(cases, 63U + 93U);
}

/// Exact, or between the same two doubles.
void expect_value(const SignedDepth& depth, const Json& answer) {
  ASSERT_TRUE(depth.status());
  EXPECT_EQ(name(*depth.status()), answer["status"]);
  const Json& value = answer["signed_depth"];
  EXPECT_EQ(depth.low_binary64(), value["low"].get<double>());
  EXPECT_EQ(depth.high_binary64(), value["high"].get<double>());
  ASSERT_EQ(depth.exact() != nullptr, value.contains("exact"));
  if (!depth.exact()) return;
  const auto number = [&](const char* field) { return mpq_class(value["exact"][field].get<std::string>()); };
  EXPECT_EQ(compare(*depth.exact(), Surd{number("plus"), number("root") * value["exact"]["sign"].get<int>()}), 0);
}

TEST(RealCases, OfConvexBodiesHaveTheStatedAnswersByEveryMethod) {
  std::size_t cases = 0, exact = 0;
  for (const auto& [pair, line, answer] : stated_cases()) {
    if (!answer.contains("signed_depth") || pair.a.pieces || pair.b.pieces) continue;
    SCOPED_TRACE(pair.id);
    const Shape a = files::shape_of(pair.a), b = files::shape_of(pair.b);
    for (const Method method : {Method::automatic, Method::exact, Method::naive}) {
      SignedDepthOptions options;
      options.cores.method = method;
      expect_value(signed_depth(a, b, options), answer);
    }
    ++cases;
    exact += answer["signed_depth"].contains("exact") ? 1 : 0;
  }
  EXPECT_EQ(cases, 132U);
  EXPECT_EQ(exact, 128U);
}

}  // namespace
}  // namespace fathom::depth
