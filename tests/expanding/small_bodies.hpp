// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies on small lattices, and what an inner polytope is by definition: for the tests of the
// expanding polytope.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/filters/support.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::expanding {

using Random = std::mt19937_64;

/// Few points on a small lattice: ties, coplanar and collinear points, flat bodies everywhere.
inline std::vector<Vector> small_body(Random& random, long reach) {
  std::vector<Vector> points(1 + random() % 9);
  const auto coordinate = [&] {
    return mpz_class(static_cast<long>(random() % static_cast<unsigned long>(2 * reach + 1)) - reach);
  };
  for (Vector& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

/// Q by definition: corners of its facets are all vertices on the facet's plane, and these are all
/// facets of the hull of its vertices.
inline void expect_hull(const InnerPolytope& inner, const kernels::PointCloud& a, const kernels::PointCloud& b) {
  std::vector<Vector> vertices;
  for (const auto& [i, j] : inner.vertices) vertices.push_back(b[j] - a[i]);
  const polytope::Polytope hull = polytope::convex_hull(vertices);
  ASSERT_EQ(hull.vertices.size(), vertices.size()) << "a vertex is not extreme";
  std::vector<std::vector<std::uint32_t>> found = inner.facets, expected;
  for (std::vector<std::uint32_t>& facet : found)
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  for (const polytope::Facet& facet : hull.facets)
    expected.emplace_back(hull.corners.begin() + facet.begin, hull.corners.begin() + facet.end);
  std::sort(found.begin(), found.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(found, expected);
}

}  // namespace fathom::expanding
