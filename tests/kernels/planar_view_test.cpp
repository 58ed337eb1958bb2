// SPDX-License-Identifier: GPL-3.0-or-later
// Every answer against integers, above all on points that are level or parallel in the view, or nearly so.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <vector>

#include "kernels/filters/support.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using testing::directions;
using testing::smallest_steps;
using testing::vectors;

/// The middle one of points o, p, q is turned about by lexicographic comparison of two determinants: the axis after the greatest
/// component of u, in cyclic order, then the one after that.
int turn_naive(const Vector& u, const Vector& op, const Vector& oq) {
  const mpz_class sizes[3] = {abs(u.x), abs(u.y), abs(u.z)};
  int up = 0;
  for (int i = 1; i < 3; ++i)
    if (sizes[i] > sizes[up]) up = i;
  const auto at = [](const Vector& v, int i) -> mpz_class { return i % 3 == 0 ? v.x : i % 3 == 1 ? v.y : v.z; };
  for (const int axis : {up + 1, up + 2}) {
    const mpz_class t = at(op, axis) * dot(u, oq) - at(oq, axis) * dot(u, op);
    if (t != 0) return sgn(t);
  }
  return 0;
}

void check_view(const Vector& u, std::vector<Vector> points) {
  const PointCloud cloud(std::move(points));
  const PlanarView view(cloud, u);
  for (std::uint32_t p = 0; p < cloud.size(); ++p) {
    for (std::uint32_t q = 0; q < cloud.size(); ++q) {
      RC_ASSERT(to_int(view.rise(p, q)) == sgn(dot(u, Vector(cloud[q] - cloud[p]))));
      RC_ASSERT(to_int(view.turn(0, p, q)) == turn_naive(u, cloud[p] - cloud[0], cloud[q] - cloud[0]));
    }
  }
}

TEST(PlanarView, EveryAnswerIsExact) {
  for (const testing::Size size : testing::all_sizes) {
    SCOPED_TRACE(testing::name(size));
    EXPECT_TRUE(rc::check("points of any place", [size] {
      check_view(*directions(size), {*vectors(size), *vectors(size), *vectors(size), *vectors(size)});
    }));
    EXPECT_TRUE(rc::check("level and parallel ones, or one unit off", [size] {
      const Vector u = *directions(size), o = *vectors(size), v = *vectors(size), level = cross(u, v);
      check_view(u, {o, o + level + *smallest_steps(), o + v, o + v + v + *smallest_steps(), o + v + u + *smallest_steps(),
                     o + mpz_class(3) * v + mpz_class(3) * u});
    }));
  }
}

TEST(PlanarView, ZeroTurnsMeanParallelOrLevel) {
  EXPECT_TRUE(rc::check([] {
    const Vector u = *directions(testing::Size::small), p = *directions(testing::Size::small), q = *directions(testing::Size::small);
    const PointCloud cloud({Vector{0, 0, 0}, p, q});
    const bool level = dot(u, p) == 0 && dot(u, q) == 0;
    RC_ASSERT((PlanarView(cloud, u).turn(0, 1, 2) == Sign::zero) == (level || is_zero(cross(p, q))));
  }));
}

}  // namespace
}  // namespace fathom::kernels
