// SPDX-License-Identifier: GPL-3.0-or-later
// The rounded bars and the twisted fans: their shape, and the two regions that compete.
#include <gtest/gtest.h>

#include "tests/support/crossing_planes.hpp"
#include "tests/support/exact_depth.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace {

using namespace fathom;
using namespace fathom::testing;
using families::find_family;
using families::ratio;

/// The nearest crossings on either side of the plane x = y, and near the direction of z, where |x|
/// and |y| are below z / 16.
struct Regions {
  Spread right, left, middle;
};

Regions regions(const Prepared& p) {
  Regions result;
  for (const MeasuredCrossing& c : measured_crossings(p)) {
    const Vector& n = c.plane.normal;
    if (n.z <= 0) continue;
    (n.x > n.y ? result.right : result.left).add(c.plane.squared());
    if (16 * abs(n.x) < n.z && 16 * abs(n.y) < n.z) result.middle.add(c.plane.squared());
  }
  return result;
}

void expect_two_minima(const Case& input, const mpq_class& share) {
  const Regions found = regions(*prepare(input));
  Spread minima;
  minima.add(found.right.least);
  minima.add(found.left.least);
  EXPECT_TRUE(minima.within(share)) << input.id << ": " << found.right.least.get_d() / found.left.least.get_d();
  EXPECT_NE(minima.least, minima.greatest) << input.id;
  ASSERT_GT(found.middle.count, 0U) << input.id;
  EXPECT_GT(found.middle.least, minima.greatest * ratio(101, 100)) << input.id << ": a saddle";
  EXPECT_EQ(fathom::testing::exact_depth(input.a.points, input.b.points).contact()->kind, ContactKind::edge_edge)
      << input.id;
}

TEST(Fillets, TwoRegionsCompete) {
  for (const unsigned n : {32U, 64U, 128U, 256U})
    for (const std::uint64_t seed : {1U, 2U, 3U})
      expect_two_minima(find_family("crossed_fillets")->make(seed, n), ratio(1, 65536) + ratio(4, n * n));
}

TEST(Twists, TwoRegionsCompete) {
  for (const unsigned n : {32U, 64U, 128U, 256U})
    for (const std::uint64_t seed : {1U, 2U, 3U})
      expect_two_minima(find_family("crossed_twists")->make(seed, n), ratio(4, n * n));
}

TEST(Fillets, ChainEdgesHaveThreeParallelCopiesAndFlatFacesBetween) {
  const unsigned n = 40, edges = n / 2;
  const auto p = prepare(find_family("crossed_fillets")->make(1, n));
  for (const polytope::Polytope* body : {&p->a, &p->b}) {
    EXPECT_EQ(body->vertices.size(), 3 * (edges + 1) + 2) << "every point is extreme";
    EXPECT_EQ(std::ranges::count_if(body->facets, [](const polytope::Facet& f) { return f.end - f.begin == 4; }),
              2 * edges + 2)
        << "and one trapezium at each end";
    const auto chain_edges = std::ranges::count_if(body->edges, [&](const polytope::Edge& e) {
      const polytope::VertexId low = std::min(e.from, e.to), high = std::max(e.from, e.to);
      return low.value >= 2 && high == low.next();  // the two points below come first, then one copy after the other
    });
    EXPECT_EQ(chain_edges, 3 * edges);
    const std::vector<Vector>& points = body->vertices;
    for (std::uint32_t i = 2; i < 2 + edges; ++i)
      for (const std::uint32_t copy : {edges + 1, 2 * edges + 2})
        EXPECT_EQ(points[i + 1] - points[i], points[copy + i + 1] - points[copy + i]);
  }
}

TEST(Twists, NoThreeEdgesOfAChainHaveDirectionsInOnePlane) {
  const unsigned n = 24;
  const auto p = prepare(find_family("crossed_twists")->make(1, n));
  for (const polytope::Polytope* body : {&p->a, &p->b}) {
    ASSERT_EQ(body->vertices.size(), n + 2) << "every point is extreme";
    const std::vector<Vector>& points = body->vertices;
    std::vector<Vector> directions;
    for (std::size_t i = 0; i + 1 < n; ++i) directions.push_back(points[i + 1] - points[i]);
    for (std::size_t i = 0; i < n - 1; ++i)
      for (std::size_t j = i + 1; j < n - 1; ++j)
        for (std::size_t k = j + 1; k < n - 1; ++k) EXPECT_NE(det(directions[i], directions[j], directions[k]), 0);
  }
}

}  // namespace
