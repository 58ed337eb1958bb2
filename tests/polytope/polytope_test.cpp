// SPDX-License-Identifier: GPL-3.0-or-later
// convex_hull against its naive twin, against known solids, and against its own laws.
#include "reference/polytope/polytope.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>

#include "reference/polytope/hull.hpp"
#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::polytope {
namespace {

using Vectors = std::vector<Vector>;

Vectors operator*(const mpz_class& scale, Vectors points) {
  for (Vector& p : points) p = {scale * p.x, scale * p.y, scale * p.z};
  return points;
}

Vectors grid(int side) {
  Vectors points;
  for (int i = 0; i < side * side * side; ++i) points.push_back({i % side, i / side % side, i / side / side});
  return points;
}

/// (0, +-a, +-b) and its cyclic shifts: an icosahedron for a/b between 0 and 1, with two kinds of
/// edges unless a/b is golden.
Vectors icosahedron(int a, int b) {
  Vectors points;
  for (const int s : {-1, 1}) {
    for (const int t : {-1, 1}) {
      points.insert(points.end(), {{0, s * a, t * b}, {t * b, 0, s * a}, {s * a, t * b, 0}});
    }
  }
  return points;
}

/// A dodecahedron with rational corners: the pyritohedron for h = 1/2.
Vectors dodecahedron() {
  Vectors points = icosahedron(3, 6);
  for (int i = 0; i < 8; ++i) points.push_back({i & 1 ? 4 : -4, i & 2 ? 4 : -4, i & 4 ? 4 : -4});
  return points;
}

/// On a sphere of radius 2^40, rounded to integers.
Vectors sphere(int count, unsigned seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  Vectors points;
  for (int i = 0; i < count; ++i) {
    const double x = normal(generator), y = normal(generator), z = normal(generator),
                 scale = std::ldexp(1 / std::hypot(x, y, z), 40);
    points.push_back(
        {mpz_class(std::round(scale * x)), mpz_class(std::round(scale * y)), mpz_class(std::round(scale * z))});
  }
  return points;
}

/// The hull in the naive twin's form.
NaiveHull as_sets(const Polytope& p) {
  NaiveHull hull;
  hull.rank = p.rank;
  hull.vertices.insert(p.input_ids.begin(), p.input_ids.end());
  for (const Edge& e : p.edges) hull.edges.insert(std::minmax(p.input_ids[e.from], p.input_ids[e.to]));
  for (const Facet& f : p.facets) {
    std::vector<std::uint32_t> ids;
    for (std::uint32_t c = f.begin; c < f.end; ++c) ids.push_back(p.input_ids[p.corners[c]]);
    std::ranges::sort(ids);
    hull.facets.insert({{f.normal.x, f.normal.y, f.normal.z}, ids});
  }
  return hull;
}

std::string faults(const Polytope& polytope, const Vectors& points) {
  std::string all;
  for (const std::string& fault : validate(polytope, points).faults) all += fault + "; ";
  return all;
}

/// Vertices, edges and facets of a hull that keeps all its laws.
std::vector<std::size_t> counts(const Vectors& points) {
  const Polytope p = convex_hull(points);
  EXPECT_EQ(faults(p, points), "");
  return {p.vertices.size(), p.edges.size(), p.facets.size()};
}

using Counts = std::vector<std::size_t>;

TEST(ConvexHull, PlatonicSolids) {
  EXPECT_EQ(counts({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), (Counts{4, 6, 4}));
  EXPECT_EQ(counts({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}), (Counts{4, 6, 4}));
  EXPECT_EQ(counts(grid(2)), (Counts{8, 12, 6}));
  EXPECT_EQ(counts({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}), (Counts{6, 12, 8}));
  EXPECT_EQ(counts(dodecahedron()), (Counts{20, 30, 12}));
  EXPECT_EQ(counts(icosahedron(987, 1597)), (Counts{12, 30, 20}));
}

TEST(ConvexHull, PointsInsideFacetsEdgesAndTheBodyAreDropped) {
  EXPECT_EQ(counts(grid(7)), (Counts{8, 12, 6}));
  EXPECT_EQ(counts(grid(3)), (Counts{8, 12, 6}));
}

TEST(ConvexHull, TheCubeInFull) {
  Vectors points{{1, 1, 1}, {0, 0, 0}};
  for (const Vector& p : grid(3))
    points.push_back(mpz_class(2) * Vectors{p} == Vectors{{2, 2, 2}} ? Vector{1, 1, 1} : p);
  const Polytope p = convex_hull(points);
  EXPECT_EQ(p.input_ids, (std::vector<std::uint32_t>{1, 4, 8, 10, 20, 22, 26, 28}));
  EXPECT_EQ(p.corners,
            kernels::to_ids<VertexId>({0, 1, 5, 4, 0, 2, 3, 1, 0, 4, 6, 2, 1, 3, 7, 5, 2, 6, 7, 3, 4, 5, 7, 6}));
  EXPECT_EQ(p.facets.front().normal, (Vector{0, -1, 0}));
  EXPECT_EQ(p.facets[FacetId(3)].normal, (Vector{1, 0, 0}));
  const Edge& first = p.edges[0];
  EXPECT_EQ(std::pair(first.from, first.to), std::pair(VertexId(0), VertexId(1)));
  EXPECT_EQ(std::pair(first.left, first.right), std::pair(FacetId(0), FacetId(1)));
}

/// Random points of a small grid, pushed through a random integer matrix: every rank, many
/// coincidences.
Vectors degenerate_points() {
  const int side = *rc::gen::inRange(2, 5), count = *rc::gen::inRange(1, 25);
  const auto matrix =
      *rc::gen::container<std::vector<int>>(9, rc::gen::weightedElement<int>({{5, 0}, {4, 1}, {2, -1}, {1, 3}}));
  const bool plain = *rc::gen::arbitrary<bool>();
  Vectors points;
  for (int i = 0; i < count; ++i) {
    const Vector p{*rc::gen::inRange(0, side), *rc::gen::inRange(0, side), *rc::gen::inRange(0, side)};
    const auto row = [&](int r) { return mpz_class(matrix[r] * p.x + matrix[r + 1] * p.y + matrix[r + 2] * p.z); };
    points.push_back(plain ? p : Vector{row(0), row(3), row(6)});
  }
  return points;
}

TEST(ConvexHull, EqualsTheNaiveTwinOnDegenerateInput) {
  std::array<int, 4> met{};
  EXPECT_TRUE(holds({.seed = 36, .runs = 1000}, [&] {
    const Vectors points = degenerate_points();
    const Polytope p = convex_hull(points);
    ++met[p.rank];
    RC_ASSERT(as_sets(p) == convex_hull_naive(points));
    RC_ASSERT(faults(p, points) == "");
  }));
  for (const int count : met) EXPECT_GT(count, 50) << "a rank hardly occurred";
}

TEST(ConvexHull, EqualsTheNaiveTwinOnSpheresGridsAndTheParaboloid) {
  Vectors paraboloid;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) paraboloid.push_back({x, y, x * x + y * y});
  }
  for (const Vectors& points : {paraboloid, sphere(30, 1), grid(3), dodecahedron(), icosahedron(1, 3)}) {
    const Polytope p = convex_hull(points);
    EXPECT_EQ(as_sets(p), convex_hull_naive(points));
    EXPECT_EQ(faults(p, points), "");
  }
}

/// The combinatorial result and the normals of scaled and moved points are those of the points.
void expect_unchanged(const Vectors& points, const mpz_class& scale, const Vector& shift) {
  Vectors moved = scale * points;
  for (Vector& p : moved) p = p + shift;
  const Polytope p = convex_hull(points), q = convex_hull(moved);
  EXPECT_EQ(faults(q, moved), "");
  EXPECT_EQ(as_sets(p), as_sets(q));
  EXPECT_EQ(p.corners, q.corners);
}

TEST(ConvexHull, HugeCoordinates) {
  const mpz_class decimal("1" + std::string(300, '0')), binary = (mpz_class(1) << 2000) + 1;
  for (const Vectors& points : {dodecahedron(), sphere(100, 2), grid(4), Vectors{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}},
                                Vectors{{1, 1, 0}, {2, 5, 0}, {7, 7, 0}}}) {
    expect_unchanged(points, decimal, {7, -decimal, 1});
    expect_unchanged(points, 1, {binary, binary * binary, -binary});
    expect_unchanged(points, binary, {decimal, 0, 1});
  }
}

/// Far beyond what doubles resolve: three points and one that lies off their plane by one unit in
/// 2^1500.
TEST(ConvexHull, AHairAboveAPlane) {
  const mpz_class far = mpz_class(1) << 1500;
  const Vector a{far, 0, 0}, b{0, far, 0}, c{0, 0, far}, o{0, 0, 0}, third{far / 3, far / 3, far / 3};
  const Vector below = third, above{third.x + 1, third.y + 1, third.z + 1};
  EXPECT_EQ(counts({a, b, c, o, below}), (Counts{4, 6, 4}));
  EXPECT_EQ(counts({a, b, c, o, above}), (Counts{5, 9, 6}));
}

TEST(ConvexHull, RandomSphere) {
  EXPECT_EQ(counts(sphere(700, 3)), (Counts{700, 2094, 1396}));
  const Vectors points = sphere(2000, 4);
  const Polytope p = convex_hull(points);
  EXPECT_EQ(p.vertices.size(), 2000u);
  EXPECT_EQ(p.facets.size(), 3996u);
  EXPECT_TRUE(validate(p, points, false).ok());
}

/// Large facets: all points of either base are coplanar, and the bases also hold points that are
/// not corners.
TEST(ConvexHull, PrismWithManyCorners) {
  Vectors points;
  const int half = 300;
  for (int i = -half; i <= half; ++i) {
    for (const int z : {0, 1, 2}) points.insert(points.end(), {{i, i * i, z}, {i, i * i / 2 + half * half, z}});
  }
  const Counts n = counts(points);
  EXPECT_EQ(n[2], n[0] / 2 + 2);
  EXPECT_EQ(n[1], n[0] / 2 * 3);
  EXPECT_GE(n[0], 2u * (2 * half + 1));
}

TEST(ConvexHull, PointAndSegment) {
  const Polytope point = convex_hull(Vectors(3, {5, -7, 9}));
  EXPECT_EQ(point.rank, 0);
  EXPECT_EQ(point.input_ids, std::vector<std::uint32_t>{0});
  const Vectors line{{2, 4, 6}, {3, 6, 9}, {1, 2, 3}, {3, 6, 9}, {1, 2, 3}, {2, 4, 6}};
  const Polytope segment = convex_hull(line);
  EXPECT_EQ(segment.rank, 1);
  EXPECT_EQ(segment.input_ids, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_TRUE(segment.edges[0].left.is_none());
  EXPECT_EQ(faults(segment, line), "");
  EXPECT_THROW(convex_hull({}), std::invalid_argument);
}

TEST(ConvexHull, PolygonsOfEveryDirection) {
  for (const Vector& n :
       {Vector{0, 0, 1}, Vector{0, 1, 0}, Vector{1, 0, 0}, Vector{0, 1, -1}, Vector{2, -3, 5}, Vector{1, 1, 0}}) {
    const Vector u = cross(n, Vector{7, 11, 13}), v = cross(n, u);
    Vectors points;
    for (int i = 0; i < 9; ++i) points.push_back((i % 3 * Vectors{u})[0] + (i / 3 * Vectors{v})[0]);
    const Polytope p = convex_hull(points);
    EXPECT_EQ(p.rank, 2);
    EXPECT_EQ(p.facets.front().normal, n);
    EXPECT_EQ(p.input_ids, (std::vector<std::uint32_t>{0, 2, 6, 8}));
    EXPECT_EQ(faults(p, points), "");
    EXPECT_EQ(as_sets(p), convex_hull_naive(points));
  }
}

bool same(const Polytope& p, const Polytope& q) {
  const auto same_edge = [](const Edge& e, const Edge& f) {
    return std::tie(e.from, e.to, e.left, e.right) == std::tie(f.from, f.to, f.left, f.right);
  };
  const auto same_facet = [](const Facet& f, const Facet& g) {
    return f.normal == g.normal && f.begin == g.begin && f.end == g.end;
  };
  return p.rank == q.rank && p.vertices == q.vertices && p.input_ids == q.input_ids && p.corners == q.corners &&
         std::ranges::equal(p.edges, q.edges, same_edge) && std::ranges::equal(p.facets, q.facets, same_facet);
}

TEST(ConvexHull, IsWrittenInOneWayOnly) {
  EXPECT_TRUE(holds({.seed = 36, .runs = 1000}, [] {
    const Vectors points = degenerate_points();
    const Polytope p = convex_hull(points);
    // More points that are not vertices change the hull's construction, not its result.
    Vectors more = mpz_class(2) * points;
    Vectors twice = more;
    for (std::size_t i = 0; i < points.size(); ++i) twice.push_back(points[i] + points[(i * 5 + 3) % points.size()]);
    RC_ASSERT(same(convex_hull(more), convex_hull(twice)));
    RC_ASSERT(p.corners == convex_hull(more).corners);
    RC_ASSERT(std::ranges::is_sorted(p.input_ids));
    RC_ASSERT(p.rank != 3 ||
              std::ranges::is_sorted(p.edges, {}, [](const Edge& e) { return std::pair(e.from, e.to); }));
    std::vector<std::vector<std::uint32_t>> cycles;
    for (const Facet& f : p.facets) {
      cycles.emplace_back(p.corners.begin() + f.begin, p.corners.begin() + f.end);
      RC_ASSERT(std::ranges::min_element(cycles.back()) == cycles.back().begin());
    }
    RC_ASSERT(p.rank != 3 || std::ranges::is_sorted(cycles));
  }));
}

TEST(ConvexHull, ReorderedInputGivesTheSameHullUnderNewIds) {
  EXPECT_TRUE(holds({.seed = 36, .runs = 1000}, [] {
    const Vectors points = degenerate_points();
    const Polytope p = convex_hull(points);
    std::vector<std::uint32_t> old_id(points.size());
    std::iota(old_id.begin(), old_id.end(), 0);
    std::shuffle(old_id.begin(), old_id.end(), std::mt19937(*rc::gen::arbitrary<unsigned>()));
    Vectors shuffled;
    for (const std::uint32_t i : old_id) shuffled.push_back(points[i]);
    // Of equal points another one may be first now: compare lowest old ids.
    const auto renamed = [&](std::uint32_t i) {
      return static_cast<std::uint32_t>(std::ranges::find(points, shuffled[i]) - points.begin());
    };
    const NaiveHull after = as_sets(convex_hull(shuffled));
    NaiveHull expected = as_sets(p), back;
    back.rank = after.rank;
    for (const auto v : after.vertices) back.vertices.insert(renamed(v));
    for (const auto& [v, w] : after.edges) back.edges.insert(std::minmax({renamed(v), renamed(w)}));
    for (auto [n, ids] : after.facets) {
      for (auto& i : ids) i = renamed(i);
      std::ranges::sort(ids);
      back.facets.insert({n, ids});
    }
    RC_ASSERT(back == expected);
  }));
}

/// Few places on a plane's grid, so that most points repeat others or lie on a line with them.
TEST(PolygonCorners, AreTheCornersOfTheHullAroundTheDirection) {
  std::mt19937_64 random(11);
  std::array<int, 4> corners{};
  for (int i = 0; i < 3000; ++i) {
    const Vector u = testing::random_direction(random, 1 + random() % 3), along = testing::random_vector(random, 2),
                 e = cross(u, along), f = cross(u, e), from = testing::random_vector(random, 40);
    Vectors points;
    const auto step = [&] { return mpz_class(static_cast<long>(random() % 4)); };
    for (std::size_t k = 1 + random() % 9; k > 0; --k) points.push_back(from + step() * e + step() * f);
    std::vector<std::uint32_t> ids(points.size());
    std::iota(ids.begin(), ids.end(), 0U);
    std::vector<std::uint32_t> cycle = polygon_corners(points, ids, u);
    const std::size_t size = cycle.size();
    for (std::size_t k = 0; size >= 3 && k < size; ++k) {
      const Vector &p = points[cycle[k]], &q = points[cycle[(k + 1) % size]], &r = points[cycle[(k + 2) % size]];
      ASSERT_GT(dot(cross(q - p, r - q), u), 0) << i;
    }
    std::sort(cycle.begin(), cycle.end());
    const Polytope hull = convex_hull(points);
    ASSERT_TRUE(std::equal(cycle.begin(), cycle.end(), hull.input_ids.begin(), hull.input_ids.end())) << i;
    ++corners[std::min<std::size_t>(size, 4) - 1];
  }
  EXPECT_GT(*std::min_element(corners.begin(), corners.end()), 100);
}

}  // namespace
}  // namespace fathom::polytope
