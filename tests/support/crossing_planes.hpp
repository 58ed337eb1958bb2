// SPDX-License-Identifier: GPL-3.0-or-later
// Exact distances of the planes that pairs of edges span, for tests that measure how near near ties
// are.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "reference/canonical/canonical_subsets.hpp"
#include "tests/support/prepared.hpp"

namespace fathom::testing {

/// The plane <normal, x> = height along an edge of B and against one of A, oriented away from O:
/// normal is not primitive.
struct SpannedPlane {
  Vector normal;
  mpz_class height;

  /// Squared distance from O, in the unit of the coordinates.
  [[nodiscard]] mpq_class squared() const {
    mpq_class result(height * height, dot(normal, normal));
    result.canonicalize();
    return result;
  }
};

/// The plane along (q, q2) of B and (p, p2) of A.
inline SpannedPlane spanned_plane(const Vector& p, const Vector& p2, const Vector& q, const Vector& q2) {
  SpannedPlane plane{cross(p2 - p, q2 - q), 0};
  plane.height = dot(plane.normal, q - p);
  if (plane.height < 0) plane = {-plane.normal, mpz_class(-plane.height)};
  return plane;
}

/// A crossing of an edge of A and an edge of B, with the ends of both as indices of the input
/// points, ascending.
struct MeasuredCrossing {
  std::array<std::uint32_t, 2> of_a, of_b;
  SpannedPlane plane;
};

inline std::vector<MeasuredCrossing> measured_crossings(const Prepared& p) {
  const auto ends = [](const polytope::Polytope& body, const chart::ChartArc& arc) {
    const polytope::Edge& edge = body.edges[arc.arc.value];
    const auto [low, high] = std::minmax(body.input_ids[edge.from], body.input_ids[edge.to]);
    return std::array<std::uint32_t, 2>{low, high};
  };
  std::vector<MeasuredCrossing> result;
  kernels::Context context;
  for (const chart::Charts& charts : p.charts) {
    const canonical::CanonicalSubsets subsets = canonical::canonical_subsets(context, charts);
    for (std::size_t k = 0; k < subsets.size(); ++k)
      for (const chart::ChartArcOfA i : subsets[k].a)
        for (const chart::ChartArcOfB j : subsets[k].b) {
          const auto a = ends(p.a, charts.of.a.arcs[chart::ChartArcId(i.value)]),
                     b = ends(p.b, charts.of.b.arcs[chart::ChartArcId(j.value)]);
          result.push_back(
              {a, b, spanned_plane(p.placed.a[a[0]], p.placed.a[a[1]], p.placed.b[b[0]], p.placed.b[b[1]])});
        }
  }
  return result;
}

/// The least and the greatest squared distance so far.
struct Spread {
  mpq_class least, greatest;
  std::size_t count = 0;

  void add(const mpq_class& squared) {
    least = count ? std::min(least, squared) : squared;
    greatest = count ? std::max(greatest, squared) : squared;
    ++count;
  }
  /// Whether the distances agree up to the factor 1 + share.
  [[nodiscard]] bool within(const mpq_class& share) const { return greatest <= least * (1 + share) * (1 + share); }
};

}  // namespace fathom::testing
