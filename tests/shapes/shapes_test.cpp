// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies by name, their poses, and the simplest form of their cores.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/shape.hpp"
#include "kernels/vector.hpp"
#include "reference/shapes/core.hpp"
#include "verify/families/random.hpp"

namespace fathom::shapes {
namespace {

const std::vector<Atom>& atoms(const Shape& shape) { return std::get<std::vector<Term>>(shape.core).at(0).atoms; }

Quaternion random_quaternion(families::Random& random) {
  const auto part = [&] { return families::ratio(random.between(-50, 50), random.between(1, 50)); };
  const mpq_class w = part(), x = part(), y = part(), z = part();
  return {w == 0 ? mpq_class(1) : w, x, y, z};
}

TEST(Shapes, LieAlongTheirAxes) {
  EXPECT_EQ(atoms(capsule(1, 2, Axis::x)), (std::vector<Atom>{{{-2, 0, 0}, {}}, {{2, 0, 0}, {}}}));
  EXPECT_EQ(capsule(1, 2).radius, 1);
  EXPECT_EQ(atoms(sphere(3)), (std::vector<Atom>{{{}, {}}}));
  EXPECT_EQ(atoms(box({1, 2, 3})).size(), 8U);
  EXPECT_EQ(atoms(cylinder(1, 2, Axis::y)),
            (std::vector<Atom>{{{0, -2, 0}, {{1, 0, 0}, {0, 0, 1}}}, {{0, 2, 0}, {{1, 0, 0}, {0, 0, 1}}}}));
  EXPECT_EQ(atoms(cone(1, 2)), (std::vector<Atom>{{{0, 0, -2}, {{1, 0, 0}, {0, 1, 0}}}, {{0, 0, 2}, {}}}));
  EXPECT_EQ(atoms(frustum(1, 3, 2, Axis::x)),
            (std::vector<Atom>{{{-2, 0, 0}, {{0, 1, 0}, {0, 0, 1}}}, {{2, 0, 0}, {{0, 3, 0}, {0, 0, 3}}}}));
  EXPECT_EQ(atoms(ellipsoid({1, 2, 3})), (std::vector<Atom>{{{}, {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}}));
  EXPECT_EQ(atoms(tapered_capsule(1, 3, 5)),
            (std::vector<Atom>{{{0, 0, -5}, {}}, {{0, 0, 5}, {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}}));
  EXPECT_EQ(tapered_capsule(1, 3, 5).radius, 1);
  EXPECT_EQ(tapered_capsule(2, 2, 5), capsule(2, 5));
  EXPECT_EQ(atoms(triangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1})).size(), 3U);
  EXPECT_EQ(with_margin(sphere(1), mpq_class(1, 2)), sphere(mpq_class(3, 2)));
  EXPECT_EQ(std::get<std::vector<Term>>(minkowski_sum(capsule(1, 2), cone(1, 1)).core).size(), 2U);
  EXPECT_EQ(minkowski_sum(capsule(1, 2), sphere(3)).radius, 4);
}

TEST(Shapes, RefuseLengthsThatAreNone) {
  const mpq_class unreduced = [] {
    mpq_class q;
    q.get_num() = 2;
    q.get_den() = 4;
    return q;
  }();
  const Pose flattening{{{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}}};
  const std::vector<std::pair<std::function<Shape()>, std::string>> cases{
      {[] { return sphere(0); }, "the radius of a sphere is not positive: 0"},
      {[] { return capsule(-1, 1); }, "the radius of a capsule is not positive: -1"},
      {[] { return capsule(1, 0); }, "the half length of a capsule is not positive: 0"},
      {[] { return tapered_capsule(1, 0, 1); }, "a radius of a tapered capsule is not positive: 0"},
      {[] { return tapered_capsule(1, 1, -1); }, "the half length of a tapered capsule is not positive: -1"},
      {[] {
         return box({1, 0, 1});
       },
       "a half length of a box is not positive: 0"},
      {[] { return cylinder(0, 1); }, "the radius of a cylinder is not positive: 0"},
      {[] { return cone(1, -1); }, "the half length of a cone is not positive: -1"},
      {[] { return frustum(1, 0, 1); }, "a radius of a frustum is not positive: 0"},
      {[] {
         return ellipsoid({1, 1, -1});
       },
       "a radius of an ellipsoid is not positive: -1"},
      {[] { return hull({}); }, "a hull of no points was given"},
      {[] { return halfspace({}, 1); }, "the normal of a half-space is 0"},
      {[] { return with_margin(sphere(1), -1); }, "a margin is negative: -1"},
      {[] {
         return minkowski_sum(sphere(1), halfspace({1, 0, 0}, 0));
       },
       "a half-space cannot be a part of a sum"},
      {[&] { return sphere(unreduced); },
       "a number is not in lowest terms over a positive denominator: mpq_class::canonicalize makes it so"},
      {[&] { return moved(sphere(1), flattening); }, "the matrix of a pose is singular"},
      {[&] {
         return moved(Shape{}, rigid_pose({1, 0, 0, 0}, {}));
       },
       "a shape has no term"},
      {[] {
         return moved(sphere(1), rigid_pose({0, 0, 0, 0}, {}));
       },
       "the quaternion of a pose is 0"},
  };
  for (const auto& [make, sentence] : cases) {
    try {
      make();
      ADD_FAILURE() << "not refused: " << sentence;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), sentence);
    }
  }
}

TEST(Shapes, AreRefusedIfMadeByHandAndBroken) {
  EXPECT_THROW(require_shape({std::vector<Term>{{{{{}, {{1, 0, 0}}}}}}, 0}), std::invalid_argument) << "one axis";
  EXPECT_THROW(require_shape({std::vector<Term>{{}}, 0}), std::invalid_argument) << "no atom";
  EXPECT_THROW(require_shape({HalfSpace{{1, 0, 0}, 0}, -1}), std::invalid_argument) << "a negative radius";
  EXPECT_NO_THROW(require_shape({HalfSpace{{1, 0, 0}, 0}, 1}));
}

TEST(Poses, OfQuaternionsAreExactlyOrthogonal) {
  families::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Quaternion q = random_quaternion(random);
    const Pose pose = rigid_pose(q, {1, 2, 3});
    const auto row = [&](std::size_t k) { return Point{pose[k][0], pose[k][1], pose[k][2]}; };
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(dot(row(j), row(k)), j == k ? 1 : 0);
    const Point x = row(0), y = row(1), z = row(2);
    EXPECT_EQ(x.x * (y.y * z.z - y.z * z.y) - x.y * (y.x * z.z - y.z * z.x) + x.z * (y.x * z.y - y.y * z.x), 1)
        << "a reflection";
    // v -> q v q^-1 by Hamilton's products.
    const auto times = [](const Quaternion& p, const Quaternion& r) {
      return Quaternion{p.w * r.w - p.x * r.x - p.y * r.y - p.z * r.z, p.w * r.x + p.x * r.w + p.y * r.z - p.z * r.y,
                        p.w * r.y - p.x * r.z + p.y * r.w + p.z * r.x, p.w * r.z + p.x * r.y - p.y * r.x + p.z * r.w};
    };
    const mpq_class square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const Quaternion turned =
        times(times(q, {0, 3, -1, 2}), {q.w / square, -q.x / square, -q.y / square, -q.z / square});
    const Point expected{turned.x + 1, turned.y + 2, turned.z + 3};
    EXPECT_EQ(atoms(moved(hull(std::vector<Point>{{3, -1, 2}}), pose)).at(0).center, expected);
  }
}

TEST(Poses, MoveTheCoreAndNotTheRadius) {
  const Pose twice{{{2, 0, 0, 5}, {0, 2, 0, 0}, {0, 0, 2, 0}}};
  EXPECT_EQ(moved(capsule(1, 2), twice), (Shape{std::vector<Term>{{{{{5, 0, -4}, {}}, {{5, 0, 4}, {}}}}}, 1}));
  EXPECT_EQ(atoms(moved(cylinder(1, 1), twice)).at(0), (Atom{{5, 0, -2}, {{2, 0, 0}, {0, 2, 0}}}));
  const Shape sum = moved(minkowski_sum(box({1, 1, 1}), cone(1, 1)), twice);
  const Shape boxes = minkowski_sum(box({1, 1, 1}), box({1, 1, 1}));
  std::vector<Point> expected = polytope_points(boxes, 64).value();
  for (Point& p : expected) p = {2 * p.x + 5, 2 * p.y, 2 * p.z};
  EXPECT_EQ(polytope_points(moved(boxes, twice), 64).value(), expected) << "the translation is added once";
  EXPECT_EQ(std::get<std::vector<Term>>(sum.core).at(1).atoms.at(1).center, (Point{0, 0, 2}));
}

TEST(Poses, MoveHalfSpacesAsTheirPoints) {
  families::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const auto number = [&] { return mpq_class(random.between(-5, 5)); };
    Pose pose;
    for (auto& row : pose)
      for (mpq_class& x : row) x = number();
    const Point normal{1, number(), number()}, p{number(), number(), number()};
    const mpq_class offset = number();
    Shape image;
    try {
      image = moved(halfspace(normal, offset), pose);
    } catch (const std::invalid_argument&) {
      continue;  // singular
    }
    const HalfSpace& half = std::get<HalfSpace>(image.core);
    const Point q = atoms(moved(hull(std::vector{p}), pose)).at(0).center;
    EXPECT_EQ(dot(normal, p) - offset, dot(half.normal, q) - half.offset);
  }
}

TEST(Simplified, RoundBallsAloneBecomeRadii) {
  families::Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Pose pose = rigid_pose(random_quaternion(random), {1, 2, 3});
    const Shape ball = simplified(moved(with_margin(ellipsoid({2, 2, 2}), 1), pose));
    EXPECT_EQ(ball, (Shape{std::vector<Term>{{{{{1, 2, 3}, {}}}}}, 3}));
  }
  const Shape egg = ellipsoid({2, 2, 3}), capsule_of_balls = tapered_capsule(1, 2, 3), disc_and_apex = cone(1, 1);
  for (const Shape& shape : {egg, capsule_of_balls, disc_and_apex, halfspace({1, 0, 0}, 1)})
    EXPECT_EQ(simplified(shape), shape);
  const Shape sheared{std::vector<Term>{{{{{}, {{2, 0, 0}, {0, 2, 0}, {1, 0, 2}}}}}}, 0},
      root{std::vector<Term>{{{{{}, {{1, 1, 0}, {1, -1, 0}, {0, 0, 1}}}}}}, 0};
  const Shape of_root{std::vector<Term>{{{{{}, {{1, 1, 0}, {1, -1, 0}, {0, 1, 1}}}}}}, 0};
  const Shape oblique{std::vector<Term>{{{{{}, {{5, 0, 0}, {3, 4, 0}, {0, 0, 5}}}}}}, 0};
  for (const Shape& shape : {sheared, root, of_root, oblique}) EXPECT_EQ(simplified(shape), shape);
  const Shape flat{std::vector<Term>{{{{{1, 0, 0}, {{}, {}}}, {{}, {{}, {}, {}}}}}}, 0};
  EXPECT_EQ(simplified(flat), (Shape{std::vector<Term>{{{{{1, 0, 0}, {}}, {{}, {}}}}}, 0})) << "atoms whose axes are 0";
}

TEST(PolytopePoints, OfSums) {
  const Shape boxes = minkowski_sum(minkowski_sum(box({1, 1, 1}), hull(std::vector<Point>{{1, 0, 0}})), box({2, 2, 2}));
  EXPECT_EQ(polytope_points(boxes, 64)->size(), 64U);
  EXPECT_FALSE(polytope_points(boxes, 63));
  EXPECT_EQ(polytope_points(boxes, 64)->front(), (Point{-2, -3, -3}));
  EXPECT_FALSE(polytope_points(cone(1, 1), 100));
  EXPECT_FALSE(polytope_points(halfspace({1, 0, 0}, 1), 100));
  EXPECT_TRUE(polytope_points(box({1, 1, 1}), 1)) << "one term is not expanded";
}

}  // namespace
}  // namespace fathom::shapes
