// SPDX-License-Identifier: GPL-3.0-or-later
// Every answer against the determinant of the definition, on points of mixed scales that often are
// nearly or exactly coplanar.
#include "kernels/filters/plane.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <vector>

#include "tests/support/property.hpp"

namespace fathom::kernels {
namespace {

using Points = std::vector<Vector>;

/// A small number, times a power of two up to 2^1500, and now and then one off.
mpz_class coordinate_of_any_size() {
  const mpz_class scaled = mpz_class(*rc::gen::inRange(-4, 5))
                           << *rc::gen::weightedElement<int>({{3, 0}, {3, 53}, {2, 60}, {1, 400}, {1, 1500}});
  return scaled + *rc::gen::weightedElement<int>({{6, 0}, {1, 1}, {1, -1}});
}

Vector any_vector() { return {coordinate_of_any_size(), coordinate_of_any_size(), coordinate_of_any_size()}; }

/// Five points; half of the time the last two are combinations of the first three, perhaps one unit
/// off.
Points five_points() {
  Points p{any_vector(), any_vector(), any_vector(), any_vector(), any_vector()};
  if (*rc::gen::arbitrary<bool>()) {
    p[3] = p[0] + p[1] - p[2];
    p[4] = p[2] + p[2] - p[1];
    p[4].z += *rc::gen::inRange(-1, 2);
  }
  return p;
}

TEST(Plane, EveryAnswerIsTheSignOfTheDeterminant) {
  int on_plane = 0, off_plane = 0;
  EXPECT_TRUE(holds({.seed = 35, .runs = 3000}, [&] {
    const Points p = five_points();
    const BoxedPoints boxed(p);
    const Plane plane(boxed, 0, 1, 2);
    const Vector n = cross(p[1] - p[0], p[2] - p[0]);
    RC_ASSERT(plane.degenerate() == is_zero(n));
    for (const std::uint32_t s : {3u, 4u, 1u}) {
      RC_ASSERT(to_int(plane.side(s)) == sgn(det(Vector(p[1] - p[0]), Vector(p[2] - p[0]), Vector(p[s] - p[0]))));
      ++(plane.side(s) == Sign::zero ? on_plane : off_plane);
    }
    RC_ASSERT(to_int(plane.rise(3, 4)) == sgn(dot(n, p[4] - p[3])));
    RC_ASSERT(plane.rise(4, 3) == -plane.rise(3, 4));
    RC_ASSERT(plane.normal() == n);
  }));
  EXPECT_GT(on_plane, 1000);
  EXPECT_GT(off_plane, 1000);
}

TEST(Plane, TurnIsTheNormalsComponentAlongTheAxis) {
  int straight = 0;
  EXPECT_TRUE(holds({.seed = 35, .runs = 3000}, [&] {
    const Points p = five_points();
    const BoxedPoints boxed(p);
    for (int axis = 0; axis < 3; ++axis) {
      RC_ASSERT(to_int(turn(boxed, axis, 2, 3, 4)) == sgn(coordinate(cross(p[3] - p[2], p[4] - p[2]), axis)));
      straight += turn(boxed, axis, 2, 3, 4) == Sign::zero;
    }
  }));
  EXPECT_GT(straight, 100);
}

TEST(Plane, OneUnitIn2To1500) {
  const mpz_class far = mpz_class(1) << 1500;
  const Points p{{far, 0, 0}, {0, far, 0}, {0, 0, far}, {far - 2, 1, 1}, {far - 2, 1, 2}, {far - 2, 1, 0}};
  const BoxedPoints boxed(p);
  const Plane plane(boxed, 0, 1, 2);
  EXPECT_EQ(plane.side(3), Sign::zero);
  EXPECT_EQ(plane.side(4), Sign::positive);
  EXPECT_EQ(plane.side(5), Sign::negative);
}

}  // namespace
}  // namespace fathom::kernels
