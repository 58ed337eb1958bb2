// SPDX-License-Identifier: GPL-3.0-or-later
// The covering property of the grid, decided exactly on its cells.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

#include "kernels/nearest.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"
#include "reference/approximate/separation.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/monitors.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::approximate {
namespace {

using VectorSet = std::set<Vector, kernels::NearestPlanes::LexicographicOrder>;

const mpq_class deltas[] = {
    1000000, 3, 1, mpq_class(1, 2), mpq_class(1, 4), mpq_class(1, 7), mpq_class(1, 100), mpq_class(1, 2500)};

/// By cosines in place of a tangent, another way to write the criterion: tan^2 = |v x p|^2 /
/// <v,p>^2 <= 2 delta + delta^2.
bool covers_by_tangent(const Vector& p, const Vector& v, const mpq_class& delta) {
  const Vector moment = cross(v, p);
  const mpz_class along = dot(v, p);
  return along > 0 && mpq_class(dot(moment, moment)) <= delta * (2 + delta) * along * along;
}

// The cone of directions that a centre covers is convex: a cell is covered if its four corners are.
TEST(Directions, EveryCellIsCoveredByItsCentre) {
  kernels::Context context;
  for (const mpq_class& delta : deltas) {
    const DirectionGrid grid(context, delta);
    for (std::uint64_t cell = 0; cell < grid.size(); ++cell) {
      const Vector centre = grid.centre(cell);
      for (const Vector& corner : grid.corners(cell)) {
        ASSERT_TRUE(covers(centre, corner, delta)) << delta << ", cell " << cell;
        ASSERT_TRUE(covers_by_tangent(centre, corner, delta)) << delta << ", cell " << cell;
      }
    }
  }
}

// The cells cover the sphere: each corner's cycle turns to the left about its centre, and each side
// is shared by two cells.
TEST(Directions, CellsTileTheSphere) {
  kernels::Context context;
  for (const mpq_class& delta : deltas) {
    const DirectionGrid grid(context, delta);
    using Side = std::pair<std::vector<mpz_class>, std::vector<mpz_class>>;
    std::map<Side, int> sides;
    const auto key = [](const Vector& v) { return std::vector<mpz_class>{v.x, v.y, v.z}; };
    VectorSet corners, centres;
    for (std::uint64_t cell = 0; cell < grid.size(); ++cell) {
      const auto quad = grid.corners(cell);
      const Vector centre = grid.centre(cell);
      const int turn = sgn(det(quad[0], quad[1], quad[2]));
      ASSERT_NE(turn, 0);
      for (int i = 0; i < 4; ++i) {
        const Vector &p = quad[i], &q = quad[(i + 1) % 4], &r = quad[(i + 2) % 4];
        ASSERT_EQ(sgn(det(p, q, r)), turn) << "convex";
        ASSERT_EQ(sgn(det(p, q, centre)), turn) << "with the centre inside";
        ++sides[turn > 0 ? Side{key(p), key(q)} : Side{key(q), key(p)}];
        corners.insert(p);
      }
      centres.insert(centre);
    }
    for (const auto& [side, count] : sides) {
      ASSERT_EQ(count, 1) << "two cells on one side of an edge";
      ASSERT_EQ(sides.count({side.second, side.first}), 1U) << "no cell beyond an edge";
    }
    // Euler: with all cells turned one way a surface that covers the sphere, and exactly once.
    EXPECT_EQ(corners.size() + grid.size(), sides.size() / 2 + 2) << delta;
    EXPECT_EQ(centres.size(), grid.size());
    EXPECT_EQ(grid.size(), 6 * grid.side() * grid.side());
  }
}

TEST(Directions, TheSecondHalfIsOppositeToTheFirst) {
  kernels::Context context;
  for (const mpq_class& delta : deltas) {
    const DirectionGrid grid(context, delta);
    VectorSet first, second;
    for (std::uint64_t cell = 0; cell < grid.size(); ++cell)
      (cell < grid.size() / 2 ? first : second).insert(grid.centre(cell));
    EXPECT_EQ(first.size(), second.size());
    for (const Vector& v : first) EXPECT_TRUE(second.contains(-v));
  }
}

TEST(Directions, RandomDirectionsAreCovered) {
  kernels::Context context;
  std::mt19937_64 random(3);
  for (const mpq_class& delta : {mpq_class(2), mpq_class(1, 4), mpq_class(1, 60)}) {
    const DirectionGrid grid(context, delta);
    for (int i = 0; i < 100; ++i) {
      const Vector v = testing::random_direction(random, i % 2 == 0 ? 2 : 50);
      bool covered = false;
      for (std::uint64_t cell = 0; cell < grid.size() && !covered; ++cell)
        covered = covers(grid.centre(cell), v, delta);
      EXPECT_TRUE(covered) << v;
    }
  }
}

// O(1 / delta): proved with a larger constant in proofs/approximate.md.
TEST(Directions, AreFew) {
  kernels::Context context;
  EXPECT_EQ(DirectionGrid(context, mpq_class(1000000)).size(), 6U);
  EXPECT_EQ(DirectionGrid(context, mpq_class(1)).size(), 6U);
  for (const int n : {2, 4, 10, 100, 2500, 10000})
    EXPECT_LE(DirectionGrid(context, mpq_class(1, n)).size(), 5U * n + 24U) << n;
}

TEST(Directions, TheCriterionIsExact) {
  // tan^2 between (1,0,0) and (1,1,1) is 2 = 2 delta + delta^2 for delta = sqrt(3) - 1 =
  // 0.73205080...
  EXPECT_TRUE(covers({1, 0, 0}, {1, 1, 1}, mpq_class(73205081, 100000000)));
  EXPECT_FALSE(covers({1, 0, 0}, {1, 1, 1}, mpq_class(73205080, 100000000)));
  // Pythagoras: cos = 3/5, so 1 + delta = 5/3 is reached exactly.
  EXPECT_TRUE(covers({7, 0, 0}, {3, 4, 0}, mpq_class(2, 3)));
  EXPECT_FALSE(covers({7, 0, 0}, {3, 4, 0}, mpq_class(2, 3) - mpq_class(1, 1000000000)));
  EXPECT_FALSE(covers({1, 0, 0}, {0, 1, 0}, 1000000)) << "a right angle is never covered";
  EXPECT_FALSE(covers({1, 0, 0}, {-1, 0, 0}, 1000000));
}

TEST(Directions, RefusesWhatIsNoDelta) {
  kernels::Context context;
  EXPECT_THROW(DirectionGrid(context, mpq_class(0)), std::invalid_argument);
  EXPECT_THROW(DirectionGrid(context, mpq_class(-1, 2)), std::invalid_argument);
  mpz_class huge = 1;
  huge <<= 100;
  EXPECT_THROW(DirectionGrid(context, mpq_class(1, huge)), std::invalid_argument);
}

// What a prepared pair says of the bodies, against the exact pipeline.

TEST(BodyPair, EqualsTheExactPipeline) {
  std::size_t penetrating = 0;
  for (const Case& input : testing::cases_of_all_families(2, 9)) {
    const Depth depth = testing::exact_depth(input.a.points, input.b.points);
    kernels::Context context;
    const BodyPair pair(context, input.a.points, input.b.points);
    ASSERT_EQ(pair.separation() ? pair.separation()->status() : Status::penetrating, depth.status()) << input.id;
    EXPECT_EQ(pair.facts().flat_a, depth.flat_a) << input.id;
    EXPECT_EQ(pair.facts().flat_b, depth.flat_b) << input.id;
    if (depth.status() != Status::penetrating) {
      const mpq_class h = testing::support(input.a.points, input.b.points, pair.separation()->normal);
      EXPECT_EQ(sgn(h), depth.status() == Status::disjoint ? -1 : 0) << input.id;
      continue;
    }
    ++penetrating;
    EXPECT_EQ(pair.facts().extreme_a, pair.a().polytope().vertices.size()) << input.id;
    EXPECT_EQ(pair.facts().extreme_b, pair.b().polytope().vertices.size()) << input.id;
    EXPECT_EQ(pair.a().polytope().vertices.size(), depth.extreme_a) << input.id;
    EXPECT_EQ(pair.b().polytope().vertices.size(), depth.extreme_b) << input.id;
    for (const Optimum& optimum : depth.optima()) {
      const Vector& n = optimum.direction;
      const mpq_class factor =
          testing::support(input.a.points, input.b.points, n) * pair.placed().denominator / dot(n, n);
      EXPECT_EQ(pair.translation(factor, n), optimum.translation()) << input.id;
      const auto [contact, witness] = pair.meeting(n, optimum.translation());
      EXPECT_EQ(contact, optimum.contact) << input.id;
      ASSERT_TRUE(witness) << input.id;
      EXPECT_EQ(witness->b - witness->a, optimum.translation());
      EXPECT_TRUE(testing::in_hull(witness->a, input.a.points, optimum.contact.a)) << input.id;
      EXPECT_TRUE(testing::in_hull(witness->b, input.b.points, optimum.contact.b)) << input.id;
      const Point& t = optimum.translation();
      EXPECT_FALSE(pair.meeting(n, {2 * t.x, 2 * t.y, 2 * t.z}).witness)
          << input.id << ": twice as far, the faces do not meet";
    }
  }
  EXPECT_GT(penetrating, 50U);
}

TEST(BodyPair, AMonitorCanStopIt) {
  const Case input = families::find_family("random_sphere")->make(1, 9);
  testing::Recorder impatient(0);
  kernels::Context stopped(&impatient), context;
  EXPECT_THROW(BodyPair(stopped, input.a.points, input.b.points), Interrupted);
  const std::vector<Point> none;
  EXPECT_THROW(BodyPair(context, none, input.b.points), std::invalid_argument);
}

}  // namespace
}  // namespace fathom::approximate
