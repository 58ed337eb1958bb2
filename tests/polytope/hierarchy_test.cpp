// SPDX-License-Identifier: GPL-3.0-or-later
// Every level against the hull of its vertices; extreme faces against the linear scan; size, levels
// and steps against n.
#include "reference/polytope/hierarchy.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <iostream>
#include <random>

#include "reference/polytope/lattice.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::polytope {
namespace {

using testing::cases_of_all_families;
using testing::text;

/// Directions in which faces of every kind are extreme, and a few in between.
std::vector<Vector> telling_directions(const Polytope& p, unsigned seed) {
  std::vector<Vector> directions{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 1, 0}, {-1, 0, 1}, {1, -1, 1}};
  for (const Facet& f : p.facets) directions.push_back(f.normal);
  for (const Edge& e : p.edges) {
    directions.push_back(p.vertices[e.to] - p.vertices[e.from]);
    if (e.left.is_none()) continue;
    directions.push_back(p.facets[e.left].normal + p.facets[e.right].normal);
    directions.push_back(cross(p.vertices[e.to] - p.vertices[e.from], Vector{1, 2, 3}));
  }
  std::mt19937_64 random(seed);
  for (int i = 0; i < 40; ++i) directions.push_back(testing::random_direction(random, i < 20 ? 2 : 70));
  std::shuffle(directions.begin(), directions.end(), random);
  if (directions.size() > 150) directions.resize(150);
  return directions;
}

void expect_scan_agrees(const Hierarchy& h, const Vector& u) {
  const auto expected = kernels::to_ids<VertexId>(kernels::extreme_points_naive(h.polytope().vertices, u));
  ASSERT_EQ(h.extreme_face(u), expected) << u;
  ASSERT_TRUE(std::ranges::binary_search(expected, h.extreme(u))) << u;
}

void expect_laws(const Polytope& p, unsigned seed) {
  const Hierarchy h(p);
  const kernels::Report report = validate(h);
  EXPECT_TRUE(report.ok()) << text(report);
  expect_scan_agrees(h, {0, 0, 0});
  for (const Vector& u : telling_directions(p, seed)) {
    expect_scan_agrees(h, u);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(Hierarchy, AgreesWithTheScanOnAllFamilies) {
  for (const unsigned size : {8U, 40U}) {
    for (const Case& input : cases_of_all_families(size < 10 ? 2 : 1, size)) {
      SCOPED_TRACE(input.id);
      const PlacedPair placed = place(input.a.points, input.b.points);
      for (const kernels::PointCloud* cloud : {&placed.a, &placed.b}) expect_laws(convex_hull(cloud->points()), size);
      ASSERT_FALSE(HasFatalFailure());
    }
  }
}

/// Points of an integer ball: facets with many corners, few edge directions, ties everywhere.
std::vector<Vector> lattice_ball(long squared_radius) {
  std::vector<Vector> points;
  for (long x = -20; x <= 20; ++x)
    for (long y = -20; y <= 20; ++y)
      for (long z = -20; z <= 20; ++z)
        if (x * x + y * y + z * z <= squared_radius) points.push_back({x, y, z});
  return points;
}

TEST(Hierarchy, MergedFacetsAreKeptWhole) {
  for (const long squared_radius : {20, 50, 101, 290}) {
    SCOPED_TRACE(squared_radius);
    expect_laws(convex_hull(lattice_ball(squared_radius)), 1);
    ASSERT_FALSE(HasFatalFailure());
  }
}

TEST(Hierarchy, AgreesWithTheScanOnSmallLattices) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const auto seed = *rc::gen::inRange(0U, 1U << 30);
    const int count = *rc::gen::inRange(1, 60), side = *rc::gen::inRange(1, 8), flat = *rc::gen::inRange(0, 4);
    std::mt19937_64 random(seed);
    const auto below = [&random](int n) { return static_cast<long>(random() % static_cast<unsigned>(n)); };
    std::vector<Vector> points;
    for (int i = 0; i < count; ++i)
      points.push_back({below(side), flat == 2 ? 0 : below(side), flat ? below(2) : below(side)});
    const Polytope p = convex_hull(points);
    const Hierarchy h(p);
    RC_ASSERT(validate(h).ok());
    for (int i = 0; i < 40; ++i) {
      const Vector u{below(7) - 3, below(7) - 3, below(7) - 3};
      const auto expected = kernels::to_ids<VertexId>(kernels::extreme_points_naive(p.vertices, u));
      RC_ASSERT(h.extreme_face(u) == expected);
      RC_ASSERT(std::ranges::binary_search(expected, h.extreme(u)));
    }
  }));
}

TEST(Hierarchy, PolygonsOfEveryNumberOfCorners) {
  std::vector<Vector> parabola;
  for (long i = 0; i < 70; ++i) {
    parabola.push_back({i, i * i, 3 * i});
    if (i < 2) continue;
    const Polytope p = convex_hull(parabola);
    ASSERT_EQ(p.rank, 2);
    expect_laws(p, 5);
    ASSERT_FALSE(HasFatalFailure());
  }
}

/// The greatest number of steps over random directions, and directions with ties.
Steps greatest_steps(const Hierarchy& h, unsigned seed) {
  std::mt19937_64 random(seed);
  const Polytope& p = h.polytope();
  Steps greatest = 0;
  for (int i = 0; i < 1000; ++i) {
    const Edge& e = p.edges[random() % p.edges.size()];
    const Vector& left = p.facets[e.left].normal;
    Steps steps = 0;
    const Vector u = i % 4 == 0   ? left
                     : i % 4 == 1 ? left + p.facets[e.right].normal
                                  : testing::random_direction(random, 40);
    EXPECT_LT(h.extreme(u, &steps).value, p.vertices.size());
    greatest = std::max(greatest, steps);
    if (i % 50 == 0) expect_scan_agrees(h, u);
  }
  return greatest;
}

// Guaranteed are 17/18 of the vertices left by each level; two thirds to three quarters are what
// remains in fact.
void expect_growth(const char* family, unsigned n) {
  SCOPED_TRACE(std::string(family) + " " + std::to_string(n));
  const Case input = families::find_family(family)->make(1, n);
  const Polytope p = convex_hull(place(input.a.points, input.b.points).b.points());
  const Hierarchy h(p);
  const std::size_t vertices = p.vertices.size(), doublings = std::bit_width(vertices);
  const Steps steps = greatest_steps(h, n);
  std::cout << family << " vertices " << vertices << " levels " << h.levels() << " size " << h.size() << " steps "
            << steps << '\n';
  EXPECT_LE(h.levels(), 3 * doublings);
  EXPECT_LE(h.size(), 30 * vertices);
  EXPECT_LE(steps, 40 + 24 * doublings);
}

TEST(Hierarchy, SizeIsLinearAndQueriesAreLogarithmic) {
  for (const unsigned n : {1000U, 10000U, 100000U}) expect_growth("random_sphere", n);
  for (const unsigned n : {100U, 5000U}) {
    for (const char* family : {"prisms_posed", "crossed_parabolas", "crossed_prisms", "crossed_fans"})
      expect_growth(family, n);
  }
}

}  // namespace
}  // namespace fathom::polytope
