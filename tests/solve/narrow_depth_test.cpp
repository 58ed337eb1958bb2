// SPDX-License-Identifier: GPL-3.0-or-later
// The answer on a narrow lattice against its naive twin, the same method on any lattice, and
// against the exact method; points given as doubles against the same points as rationals.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fathom/certificate.hpp"
#include "fathom/numbers.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/solve/depth.hpp"
#include "tests/solve/same_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/prepared.hpp"
#include "verify/families/solids.hpp"

namespace fathom::solve {
namespace {

using Doubles = std::vector<std::array<double, 3>>;

/// The points, rounded to binary64.
Doubles doubles(const Body& body) {
  Doubles result;
  for (const Point& p : body.points) result.push_back({round_binary64(p.x), round_binary64(p.y), round_binary64(p.z)});
  return result;
}

bool finite(const Doubles& body) {
  for (const std::array<double, 3>& p : body)
    for (const double c : p)
      if (!std::isfinite(c)) return false;
  return true;
}

TEST(NarrowDepth, EqualsTheTwinOnEveryFamily) {
  Workspace workspace;
  std::size_t answered = 0;
  for (const unsigned size : {5U, 14U}) {
    for (const Case& input : testing::cases_of_all_families(3, size)) {
      SCOPED_TRACE(input.id);
      kernels::Context context;
      Options options;
      const NarrowResult narrow = depth_on_narrow_lattice(context, input.a.points, input.b.points, options);
      options.workspace = &workspace;
      const NarrowResult again = depth_on_narrow_lattice(context, input.a.points, input.b.points, options);
      EXPECT_EQ(narrow.end, again.end);
      if (!narrow.depth) continue;
      ++answered;
      kernels::Context other;
      expect_equal(*narrow.depth, depth_by_method(other, polytope::place(input.a.points, input.b.points), {}));
      expect_equal(*again.depth, *narrow.depth);
    }
  }
  EXPECT_GT(answered, 150U);
}

TEST(NarrowDepth, DoublesStandForTheirExactValues) {
  Workspace workspace;
  std::size_t penetrating = 0, others = 0;
  for (const Case& input : testing::cases_of_all_families(3, 10)) {
    const Doubles a = doubles(input.a), b = doubles(input.b);
    if (!finite(a) || !finite(b)) continue;
    SCOPED_TRACE(input.id);
    Options options;
    options.workspace = &workspace;
    const std::vector<Point> exact_a = polytope::exact_points(a), exact_b = polytope::exact_points(b);
    const Depth depth = penetration_depth(a, b, options);
    ++(depth.penetration() ? penetrating : others);
    expect_equal(depth, penetration_depth(exact_a, exact_b));
    testing::expect_same_answer(depth, testing::exact_depth(exact_a, exact_b));
    const std::string text = certificate_text(make_certificate(exact_a, exact_b, depth));
    EXPECT_EQ(certificate_text(a, b, depth), text);
    EXPECT_EQ(certificate_text(exact_a, exact_b, depth), text);
  }
  EXPECT_GT(penetrating, 80U);
  EXPECT_GT(others, 5U);
}

TEST(NarrowDepth, HandsOverWhatItCannotAnswer) {
  kernels::Context context;
  const Doubles cube = doubles(families::cube()), point{{5, 0, 0}}, corner{{1, 0, 0}},
                far{{0x1p900, 0, 0}, {0x1p-900, 0, 0}};
  const auto end = [&](const Doubles& a, const Doubles& b, const Options& options = {}) {
    return depth_on_narrow_lattice(context, a, b, options).end;
  };
  EXPECT_EQ(end(cube, cube), NarrowEnd::answered);
  EXPECT_EQ(end(cube, point), NarrowEnd::failed) << "disjoint";
  EXPECT_EQ(end(cube, corner), NarrowEnd::failed) << "touching";
  EXPECT_EQ(end(cube, far), NarrowEnd::not_tried) << "a lattice of 1800 bits";
  Options options;
  options.expansion_budget = 0;
  EXPECT_EQ(end(cube, cube, options), NarrowEnd::failed) << "no budget";
  options.method = Method::certificate;
  EXPECT_EQ(end(cube, cube, options), NarrowEnd::answered) << "which has none";
  for (const Method method : {Method::exact, Method::naive}) {
    options.method = method;
    EXPECT_EQ(end(cube, cube, options), NarrowEnd::not_tried);
  }
  EXPECT_EQ(penetration_depth(cube, point).status(), Status::disjoint);
  EXPECT_EQ(penetration_depth(cube, corner).status(), Status::touching);
  EXPECT_EQ(penetration_depth(cube, far).status(), Status::penetrating);
}

TEST(NarrowDepth, RefusesBadInput) {
  const Doubles cube = doubles(families::cube()), none, bad{{0, std::nan(""), 0}};
  EXPECT_THROW(penetration_depth(cube, none), std::invalid_argument);
  EXPECT_THROW(penetration_depth(none, cube), std::invalid_argument);
  EXPECT_THROW(penetration_depth(cube, bad), std::invalid_argument);
  EXPECT_THROW(penetration_depth(bad, cube), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::solve
