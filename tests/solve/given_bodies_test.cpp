// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies given in binary64 against the same exact points: equal answers and certificates; and on
// the way from the text of a case to its answer no point becomes rational. GMP's allocations are
// counted.
#include <fmt/format.h>
#include <gmp.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "fathom/certificate.hpp"
#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "tests/solve/same_depth.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::solve {
namespace {

std::size_t allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  return std::malloc(size);
}
void* counted_again(void* memory, std::size_t, std::size_t size) {
  ++allocations;
  return std::realloc(memory, size);
}
void freed(void* memory, std::size_t) { std::free(memory); }

/// The points, rounded to binary64; nullopt if one overflows.
std::optional<Body> rounded(const Body& body) {
  std::vector<std::array<double, 3>> points;
  for (const Point& p : body.points) {
    points.push_back({round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)});
    for (const double c : points.back())
      if (!std::isfinite(c)) return std::nullopt;
  }
  return Body{GivenPoints(std::move(points))};
}

std::vector<Case> cases_in_binary64() {
  std::vector<Case> result;
  for (const Case& input : testing::cases_of_all_families(2, 9)) {
    const std::optional<Body> a = rounded(input.a), b = rounded(input.b);
    if (a && b) result.push_back({input.id, *a, *b});
  }
  return result;
}

TEST(GivenBodies, AreAnsweredAsTheirExactPoints) {
  std::size_t apart = 0;
  for (const Case& input : cases_in_binary64()) {
    SCOPED_TRACE(input.id);
    const std::vector<Point>&a = input.a.points, &b = input.b.points;
    const Depth depth = penetration_depth(input.a, input.b), exact = penetration_depth(a, b);
    expect_equal(depth, exact);
    EXPECT_EQ(certificate_text(input.a, input.b, depth, "id"), certificate_text(a, b, exact, "id"));
    const Body a_alone{a};  // the other body is in binary64
    expect_equal(penetration_depth(a_alone, input.b), exact);
    EXPECT_EQ(certificate_text(a_alone, input.b, exact, "id"), certificate_text(a, b, exact, "id"));
    apart += depth.status() != Status::penetrating ? 1U : 0U;
    if (!exact.penetration()) continue;
    EXPECT_EQ(second_nearest_squared(input.a, input.b, *exact.penetration()),
              second_nearest_squared(a, b, *exact.penetration()));
  }
  EXPECT_GT(apart, 10U);
}

std::string vertices(const Body& body) {
  std::string text;
  for (const auto& [x, y, z] : body.points.binary64())
    text += fmt::format("{}[{},{},\"{}\"]", text.empty() ? "" : ",", x, y, hex_text(z));
  return "{\"vertices\":[" + text + "]}";
}

TEST(GivenBodies, BecomeNoRationalsOnTheWayToAnAnswer) {
  mp_set_memory_functions(counted, counted_again, freed);
  Options options;
  Workspace workspace;
  options.workspace = &workspace;
  std::size_t narrow = 0;
  for (const Case& input : cases_in_binary64()) {
    SCOPED_TRACE(input.id);
    const std::string plain = fmt::format(R"({{"a":{},"b":{}}})", vertices(input.a), vertices(input.b));
    const CaseItem item = parse_case(plain, "case");
    ASSERT_TRUE(item.ok()) << plain;
    const Case& read = item.value();
    ASSERT_TRUE(read.a.points.in_binary64() && read.b.points.in_binary64());
    EXPECT_TRUE(read.a.points == input.a.points && read.b.points == input.b.points);
    const auto cost = [&](const auto& ask) {
      const std::size_t before = allocations;
      const Depth depth = ask();
      static_cast<void>(certificate_text(read.a, read.b, depth));
      narrow += depth.method == Method::certificate ? 1U : 0U;
      return allocations - before;
    };
    cost([&] { return penetration_depth(read.a, read.b, options); });  // memory grows
    const std::size_t by_bodies = cost([&] { return penetration_depth(read.a, read.b, options); });
    const std::size_t by_doubles =
        cost([&] { return penetration_depth(read.a.points.binary64(), read.b.points.binary64(), options); });
    EXPECT_EQ(by_bodies, by_doubles);
  }
  EXPECT_GT(narrow, 100U);
}

TEST(GivenBodies, AreReadFromPlainNumbersWithoutGmp) {
  mp_set_memory_functions(counted, counted_again, freed);
  const std::string text =
      R"({"a":{"vertices":[[0.1,2,-3e-7],[1e300,5e-300,0]]},"b":{"vertices":[[1,2,3]]},"pose_rounding":"binary64"})";
  const std::size_t before = allocations;
  const CaseItem item = parse_case(text, "case");
  EXPECT_EQ(allocations, before);
  ASSERT_TRUE(item.ok());
  EXPECT_EQ(item.value().a.points[0].x, mpq_class(0.1));
  EXPECT_GT(allocations, before) << "exact points were asked for";
}

}  // namespace
}  // namespace fathom::solve
