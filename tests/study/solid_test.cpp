// SPDX-License-Identifier: GPL-3.0-or-later
// Centres, axes and faces against the support function, by their definitions.
#include "verify/study/solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "tests/support/random_shapes.hpp"

namespace fathom::studies {
namespace {

mpq_class random_rational(families::Random& random) {
  return families::ratio(random.between(-9, 9), random.between(1, 5));
}

Vector random_direction(families::Random& random) {
  for (;;) {
    const Vector v{mpz_class(random.between(-9, 9)), mpz_class(random.between(-9, 9)),
                   mpz_class(random.between(-9, 9))};
    if (!is_zero(v)) return v;
  }
}

TEST(RootSum, IsZeroWhereTheNumberIs) {
  families::Random random(3);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    RootSum sum;
    double value = 0;
    for (int k = 0; k < 4; ++k) {
      const mpq_class factor(random.between(-3, 3));
      const mpq_class square = mpq_class(random.between(0, 12)) * families::ratio(1, k == 3 ? 4 : 1);
      sum.add(factor, square);
      value += factor.get_d() * std::sqrt(square.get_d());
    }
    EXPECT_EQ(sum.is_zero(), std::fabs(value) < 1e-12) << i;  // so small numbers are 0 or farther from it
    zeros += sum.is_zero() ? 1 : 0;
  }
  EXPECT_GT(zeros, 50);
}

TEST(RootVector, IsParallelToItsMultiplesAlone) {
  const RootVector u{{1, 0, 0}, {0, 1, 0}, 2}, v{{1, 0, 0}, {}, 0}, w{{0, 2, 0}, {1, 0, 0}, 2};  // w = sqrt(2) u
  EXPECT_TRUE(parallel(u, u) && parallel(u, w) && parallel(w, u) && parallel(v, v));
  EXPECT_TRUE(parallel(u, {{3, 0, 0}, {0, mpq_class(3, 2), 0}, 8}));  // 3 u
  EXPECT_FALSE(parallel(u, v) || parallel(v, u) || parallel(w, v) || parallel(u, {{1, 0, 0}, {0, 1, 0}, 3}));
  EXPECT_FALSE(parallel(u, {{1, 0, 0}, {0, -1, 0}, 2}));
}

RootSum height(const Solid& solid, const Vector& u) { return support_face(solid.terms(), u).height; }

/// Whether h(u) - <c,u> has the same value at -u.
bool mirrored(const Solid& solid, const RationalVector& c, const Vector& u) {
  RootSum difference = height(solid, u);
  difference.add(height(solid, -u), -1);
  difference.add(-2 * dot(c, rational_vector(u)));
  return difference.is_zero();
}

/// The rotation v -> q v q^-1 of a direction, as an integer vector of another length: times |q|^2.
Vector turned(const Vector& axis, const mpz_class& w, const Vector& u) {
  const Vector c = cross(axis, u);
  const mpz_class square = w * w - dot(axis, axis), along = 2 * dot(axis, u), twice = 2 * w;
  return {square * u.x + along * axis.x + twice * c.x, square * u.y + along * axis.y + twice * c.y,
          square * u.z + along * axis.z + twice * c.z};
}

/// Whether h, seen from the axis, is the same in two directions that a turn about the axis maps to
/// each other.
bool turns(const Solid& solid, const Line& axis, const Vector& u, const mpz_class& w) {
  const mpz_class length = w * w + dot(axis.direction, axis.direction);
  const Vector v = turned(axis.direction, w, u);
  EXPECT_EQ(dot(v, v), length * length * dot(u, u));
  RootSum difference = height(solid, v);
  difference.add(-dot(axis.point, rational_vector(v)));
  difference.add(height(solid, u), -length);
  difference.add(length * dot(axis.point, rational_vector(u)));
  return difference.is_zero();
}

TEST(Solid, CentresAndAxesAreThoseOfTheSupport) {
  const std::set<std::string_view> with_centre{"ellipsoid",        "cylinder",        "box",           "disc", "ball",
                                               "rounded_cylinder", "ellipsoid + box", "flat ellipsoid"};
  const std::set<std::string_view> with_axis{"cylinder", "cone", "frustum", "tapered_capsule", "rounded_cylinder"};
  testing::ShapeMaker maker{families::Random(11), 20};
  for (int i = 0; i < 20; ++i) {
    for (const std::string_view kind : testing::ShapeMaker::kinds) {
      const Solid solid = solid_of(maker.posed(maker.shape(kind), 3));
      EXPECT_EQ(solid.centre.has_value(), with_centre.contains(kind)) << kind;
      EXPECT_EQ(solid.axis.has_value(), with_axis.contains(kind)) << kind;
      for (int k = 0; k < 10; ++k) {
        const Vector u = random_direction(maker.random);
        EXPECT_TRUE(!solid.centre || mirrored(solid, *solid.centre, u)) << kind;
        EXPECT_TRUE(!solid.axis || turns(solid, *solid.axis, u, 2)) << kind;
      }
    }
  }
}

// Affine images of balls and discs whose axes are not orthogonal: of revolution as a set.
TEST(Solid, FindsTheAxisOfASpheroidInAnyForm) {
  families::Random random(17);
  for (int i = 0; i < 200; ++i) {
    const Quaternion q{random_rational(random), random_rational(random), random_rational(random), mpq_class(1)};
    const mpq_class thick = families::ratio(random.between(1, 9), 4),
                    high = thick + families::ratio(random.between(1, 9), 4);
    const Shape egg = moved(ellipsoid({thick, thick, high}), rigid_pose(q, {1, 2, 3}));
    const Solid solid = solid_of(egg);
    ASSERT_TRUE(solid.axis) << i;
    // The same set by other axes: those of a turn of the unit ball.
    Shape other = egg;
    Atom& atom = std::get<std::vector<Term>>(other.core).front().atoms.front();
    const std::vector<Point> m = atom.axes;
    const auto mix = [](const mpq_class& s, const Point& p, const mpq_class& t, const Point& r) {
      return Point{s * p.x + t * r.x, s * p.y + t * r.y, s * p.z + t * r.z};
    };
    const mpq_class c(3, 5), s(4, 5);
    atom.axes = {mix(c, m[0], s, m[2]), m[1], mix(-s, m[0], c, m[2])};
    const Solid again = solid_of(other);
    ASSERT_TRUE(again.axis) << i;
    EXPECT_TRUE(again.axis->direction == solid.axis->direction || again.axis->direction == -solid.axis->direction) << i;
    EXPECT_FALSE(solid_of(moved(ellipsoid({thick, high, high + thick}), rigid_pose(q, {}))).axis) << i;
  }
}

TEST(Solid, AnEllipticCylinderHasNoAxis) {
  Shape drum = cylinder(1, 2);
  for (Atom& atom : std::get<std::vector<Term>>(drum.core).front().atoms)
    atom.axes = {{1, 1, 0}, {-2, 2, 0}};  // as wide along x as along y
  const Solid solid = solid_of(drum);
  EXPECT_FALSE(solid.axis);
  EXPECT_TRUE(solid.centre);
  ASSERT_EQ(solid.sides.size(), 1U);
  EXPECT_FALSE(solid.sides.front().radius);
}

TEST(Solid, FacesOfNamedShapes) {
  const auto faces = [](const Shape& shape) { return solid_of(shape).faces.size(); };
  EXPECT_EQ(faces(box({1, 2, 3})), 6U);
  EXPECT_EQ(faces(with_margin(box({1, 2, 3}), 1)), 6U);
  EXPECT_EQ(faces(cylinder(1, 2)), 2U);
  EXPECT_EQ(faces(cone(1, 2)), 1U);
  EXPECT_EQ(faces(frustum(1, 2, 2)), 2U);
  EXPECT_EQ(faces(sphere(1)) + faces(capsule(1, 2)) + faces(ellipsoid({1, 2, 3})) + faces(tapered_capsule(1, 2, 3)),
            0U);
  EXPECT_EQ(faces(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})), 2U);
  EXPECT_EQ(faces(halfspace({2, 0, 4}, 1)), 1U);
  EXPECT_EQ(faces(minkowski_sum(cylinder(1, 2), box({1, 1, 1}))), 6U);  // as of a box with rounded edges along z
  EXPECT_EQ(faces(minkowski_sum(cylinder(1, 2), cylinder(1, 2, Axis::x))), 6U);
  EXPECT_EQ(faces(minkowski_sum(ellipsoid({1, 2, 3}), box({1, 1, 1}))), 6U);
}

}  // namespace
}  // namespace fathom::studies
