// SPDX-License-Identifier: GPL-3.0-or-later
// The covering property of the grid, decided exactly on its cells; and the guarantee of
// APPROX-SEPARATION, against the exact depth.
#include "reference/approximate/separation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <stdexcept>

#include "kernels/nearest.hpp"
#include "kernels/vector.hpp"
#include "reference/approximate/ray.hpp"
#include "tests/approximate/naive_rays.hpp"
#include "tests/support/check_depth.hpp"
#include "tests/support/exact_depth.hpp"
#include "tests/support/monitors.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::approximate {
namespace {

using VectorSet = std::set<Vector, LexicographicOrder>;

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

using testing::cases_of_all_families;
using testing::differences;
using testing::square;

mpq_class squared_length(const Point& t) { return t.x * t.x + t.y * t.y + t.z * t.z; }

/// bound <= depth <= |t| <= (1 + delta) bound, and t separates along the direction returned.
void expect_guarantee(const ApproxDepth& approx, const Depth& exact, std::span<const Point> a, std::span<const Point> b,
                      const std::string& what) {
  EXPECT_EQ(approx.status(), exact.status()) << what;
  EXPECT_EQ(std::pair(approx.flat_a, approx.flat_b), std::pair(exact.flat_a, exact.flat_b)) << what;
  EXPECT_EQ(squared_length(approx.translation()), approx.squared()) << what;
  EXPECT_LE(exact.squared(), approx.squared()) << what;
  EXPECT_LE(approx.squared(), square(1 + approx.delta) * approx.bound_squared()) << what;
  EXPECT_LE(approx.bound_squared(), exact.squared()) << what;
  if (exact.status() != Status::penetrating) {
    EXPECT_EQ(approx.squared(), 0) << what;
    EXPECT_EQ(approx.bound_squared(), 0) << what;
    EXPECT_EQ(sgn(testing::support(a, b, approx.direction())), exact.status() == Status::disjoint ? -1 : 0) << what;
    return;
  }
  const Vector& n = approx.direction();
  const mpq_class h = testing::support(a, b, n), s = h / dot(n, n);
  EXPECT_EQ(approx.translation(), (Point{s * n.x, s * n.y, s * n.z}))
      << what << ": h(n) = <n,t>, so A + t and B lie on two sides of a plane";
  const ApproxPenetration& found = *approx.penetration();
  EXPECT_EQ(found.contact.kind, testing::kind_of(found.contact, a, b)) << what;
  EXPECT_EQ(found.contact.a, testing::face(a, -n)) << what;
  EXPECT_EQ(found.contact.b, testing::face(b, n)) << what;
  if (!found.witness) return;
  EXPECT_EQ(found.witness->b - found.witness->a, found.translation) << what;
  EXPECT_TRUE(testing::in_hull(found.witness->a, a, found.contact.a)) << what;
  EXPECT_TRUE(testing::in_hull(found.witness->b, b, found.contact.b)) << what;
}

TEST(Separation, KeepsItsGuaranteeOnEveryFamily) {
  kernels::Context context;
  std::size_t penetrating = 0, off = 0;
  for (const Case& input : cases_of_all_families(2, 9)) {
    const Depth exact = testing::exact_depth(input.a.points, input.b.points);
    for (const mpq_class& delta : {mpq_class(1), mpq_class(1, 4)}) {
      const ApproxDepth approx = approx_depth(input.a.points, input.b.points, delta);
      expect_guarantee(approx, exact, input.a.points, input.b.points, input.id);
      if (exact.status() == Status::penetrating) {
        ++penetrating;
        EXPECT_EQ(approx.penetration()->rays, DirectionGrid(context, delta).size()) << input.id;
      }
      if (exact.squared() < approx.squared()) ++off;
    }
  }
  EXPECT_GT(penetrating, 100U);
  EXPECT_GT(off, 0U) << "all exact: nothing was put to the test";
}

TEST(Separation, KeepsItsGuaranteeWithManyRays) {
  const std::vector<Case> cases = cases_of_all_families(1, 6);
  for (const Case& input : cases) {
    const Depth exact = testing::exact_depth(input.a.points, input.b.points);
    expect_guarantee(approx_depth(input.a.points, input.b.points, mpq_class(1, 100)), exact, input.a.points,
                     input.b.points, input.id);
  }
  for (const char* name : {"random_sphere", "near_ties"}) {
    const Case input = families::find_family(name)->make(1, 8);
    const Depth exact = testing::exact_depth(input.a.points, input.b.points);
    expect_guarantee(approx_depth(input.a.points, input.b.points, mpq_class(1, 2500)), exact, input.a.points,
                     input.b.points, input.id);
  }
}

// The plane of a facet instead of the hit point: never farther than the nearest hit, which the
// naive twin finds too.
TEST(Separation, TheReachIsThatOfTheNearestRay) {
  kernels::Context context;
  const mpq_class delta(1, 4);
  const DirectionGrid grid(context, delta);
  std::size_t shorter = 0, moved = 0;
  for (const Case& input : cases_of_all_families(1, 8)) {
    const polytope::PlacedPair placed = polytope::place(input.a.points, input.b.points);
    const polytope::Polytope a = polytope::convex_hull(placed.a.points()), b = polytope::convex_hull(placed.b.points());
    const polytope::Hierarchy hierarchy_a(a), hierarchy_b(b);
    for (const Vector& shift : {Vector{0, 0, 0}, Vector{1, 0, -2}}) {
      const polytope::Polytope p = differences(placed, shift);
      if (!testing::holds_origin(p)) continue;
      if (!is_zero(shift)) ++moved;
      const ApproxSeparation found = approx_separation(context, hierarchy_a, hierarchy_b, delta, shift);
      mpq_class reach = -1;
      for (std::uint64_t i = 0; i < grid.size(); ++i) {
        const Vector u = grid.centre(i);
        const mpq_class squared = square(testing::factor_naive(p, u)) * dot(u, u);
        if (reach < 0 || squared < reach) reach = squared;
      }
      EXPECT_TRUE(found.inside);
      EXPECT_EQ(found.reach_squared, reach) << input.id;
      EXPECT_EQ(square(testing::factor_naive(p, found.ray)) * dot(found.ray, found.ray), reach) << input.id;
      const mpq_class squared = kernels::ratio(found.height * found.height, dot(found.normal, found.normal));
      EXPECT_LE(squared, reach) << input.id;
      if (squared < reach) ++shorter;
      const auto facet = std::find_if(p.facets.begin(), p.facets.end(),
                                      [&](const polytope::Facet& f) { return f.normal == found.normal; });
      ASSERT_NE(facet, p.facets.end()) << input.id << ": not the normal of a facet";
      EXPECT_EQ(testing::height(p, *facet), found.height) << input.id;
    }
  }
  EXPECT_GT(shorter, 10U);
  EXPECT_GT(moved, 10U);
}

// With O on the boundary some ray leaves P at once; outside, no ray says anything.
TEST(Separation, OffTheInterior) {
  kernels::Context context;
  const std::vector<Vector> corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
  const std::vector<Vector> point{{0, 0, 0}};
  const polytope::Polytope a = polytope::convex_hull(point), b = polytope::convex_hull(corners);
  const polytope::Hierarchy hierarchy_a(a), hierarchy_b(b);
  for (const Vector& shift : {Vector{0, 0, 0}, Vector{1, 1, 0}, Vector{1, 1, 2}, Vector{3, 0, 1}}) {
    const ApproxSeparation found = approx_separation(context, hierarchy_a, hierarchy_b, mpq_class(1, 4), shift);
    EXPECT_TRUE(found.inside);
    EXPECT_EQ(found.reach_squared, 0);
    EXPECT_EQ(found.height, 0);
  }
  for (const Vector& shift : {Vector{2, 2, 2}, Vector{-1, 1, 1}}) {
    EXPECT_FALSE(approx_separation(context, hierarchy_a, hierarchy_b, mpq_class(1, 4), shift).inside);
  }
  const ApproxSeparation inside = approx_separation(context, hierarchy_a, hierarchy_b, mpq_class(1, 4), {1, 1, 1});
  EXPECT_TRUE(inside.inside);
  EXPECT_EQ(kernels::ratio(inside.height * inside.height, dot(inside.normal, inside.normal)), mpq_class(1, 3));
}

TEST(ApproxWidth, KeepsItsGuaranteeWithHalfOfTheRays) {
  kernels::Context context;
  std::size_t solids = 0;
  for (const Case& input : cases_of_all_families(2, 10)) {
    const std::vector<Point>& points = input.a.points;
    const Depth exact = width(points);
    for (const mpq_class& delta : {mpq_class(1), mpq_class(1, 10)}) {
      const ApproxDepth approx = fathom::approx_width(points, delta);
      expect_guarantee(approx, exact, points, points, input.id);
      if (exact.status() != Status::penetrating) continue;
      ++solids;
      EXPECT_EQ(approx.penetration()->rays, DirectionGrid(context, delta).size() / 2) << input.id;
    }
  }
  EXPECT_GT(solids, 100U);
}

TEST(Separation, RefusesWhatIsNoDelta) {
  const std::vector<Point> one{{0, 0, 0}}, none;
  EXPECT_THROW(approx_depth(one, one, 0), std::invalid_argument);
  EXPECT_THROW(approx_depth(one, one, mpq_class(-1, 3)), std::invalid_argument);
  EXPECT_THROW(fathom::approx_width(one, 0), std::invalid_argument);
  EXPECT_THROW(approx_depth(one, none, 1), std::invalid_argument);
}

TEST(Separation, AMonitorHearsOfProgressAndCanStopTheRun) {
  const Case input = families::find_family("random_sphere")->make(1, 20);
  testing::Recorder all;
  approx_depth(input.a.points, input.b.points, mpq_class(1, 50), &all);
  EXPECT_GT(all.stages.size(), 4U);
  for (const double share : all.shares) EXPECT_TRUE(share >= 0 && share <= 1) << share;
  for (std::size_t stop = 1; stop <= all.stages.size(); ++stop) {
    testing::Recorder some(stop);
    EXPECT_THROW(approx_depth(input.a.points, input.b.points, mpq_class(1, 50), &some), Interrupted);
    EXPECT_EQ(some.stages.size(), stop);
  }
}

// Where APPROX-SEPARATION, taken to the letter, is off by more than a factor of 1 + delta.
//                                                                                [proofs/errata.md]

/// The sum of the first `terms` terms of the series of cos(sqrt(d)). For 0 <= d <= 2 they alternate
/// and fall: an upper bound when their number is odd, a lower one when it is even.
mpq_class cosine_of_root(const mpq_class& d, int terms) {
  mpq_class sum, term = 1;
  for (int k = 1; k <= terms; ++k) {
    sum += term;
    term *= -d / (2 * k * (2 * k - 1));
  }
  return sum;
}

// The paper's grid has a point within the angle sqrt(delta) of every direction, and 1 /
// cos(sqrt(delta)) is to be at most 1 + delta.
TEST(SeparationErrata, TheBoundOfLemma31FailsForLargeDelta) {
  for (const mpq_class& d : {mpq_class(1, 4), mpq_class(1), mpq_class(121, 100)})
    EXPECT_GE((1 + d) * cosine_of_root(d, 8), 1) << d;
  for (const mpq_class& d : {mpq_class(61, 50), mpq_class(3, 2), mpq_class(2)})
    EXPECT_LT((1 + d) * cosine_of_root(d, 9), 1) << d;
  // Its middle step, 1 / (1 - alpha^2 / 2) <= 1 + alpha^2, fails from alpha = 1 on.
  for (const mpq_class& d : {mpq_class(1, 4), mpq_class(1)}) EXPECT_GE((1 + d) * (1 - d / 2), 1) << d;
  EXPECT_LT((1 + mpq_class(101, 100)) * (1 - mpq_class(101, 200)), 1);
}

const mpq_class delta(38, 25);
const std::array<Vector, 4> grid{Vector{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

// Four directions, to the corners of a regular tetrahedron. Those farthest from them are the
// opposites, where the cosine is 1/3.
TEST(SeparationErrata, FourDirectionsAreAGridByThePapersCriterion) {
  EXPECT_LT(cosine_of_root(delta, 5), mpq_class(1, 3))
      << "the angle sqrt(delta) is larger than that with the cosine 1/3";
  const auto near = [](const Vector& p, const Vector& v) {
    const mpz_class along = dot(p, v);
    return along > 0 && 9 * along * along >= dot(p, p) * dot(v, v);
  };
  std::mt19937_64 random(1);
  std::vector<Vector> directions;
  for (const Vector& p : grid) directions.insert(directions.end(), {p, -p});
  for (int i = 0; i < 2000; ++i) directions.push_back(testing::random_direction(random, i % 2 == 0 ? 3 : 40));
  for (const Vector& v : directions) {
    bool any = false;
    for (const Vector& p : grid) any = any || near(p, v);
    EXPECT_TRUE(any) << v;
  }
}

// P is that tetrahedron. Every ray of the grid runs into a corner, three times as far from O as the
// facets are.
TEST(SeparationErrata, ThatGridIsOffByAFactorOfThree) {
  const std::vector<Point> a{{0, 0, 0}};
  std::vector<Point> b;
  for (const Vector& p : grid) b.push_back({p.x, p.y, p.z});
  const mpq_class squared = testing::exact_depth(a, b).squared();
  EXPECT_EQ(squared, mpq_class(1, 3));
  const polytope::Polytope tetrahedron = polytope::convex_hull(grid);
  for (const Vector& p : grid) {
    const mpq_class factor = testing::factor_naive(tetrahedron, p);
    EXPECT_EQ(factor * factor * dot(p, p), 9 * squared);
    EXPECT_GT(factor * factor * dot(p, p), (1 + delta) * (1 + delta) * squared) << "longer than the guarantee allows";
    for (const Vector& q : grid) EXPECT_FALSE(covers(p, -q, delta)) << "the criterion used here refuses the grid";
  }
  const ApproxDepth approx = approx_depth(a, b, delta);
  EXPECT_LE(approx.squared(), (1 + delta) * (1 + delta) * approx.bound_squared());
  EXPECT_LE(approx.bound_squared(), squared);
}

}  // namespace

}  // namespace fathom::approximate
