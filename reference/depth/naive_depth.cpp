// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "kernels/number/rational.hpp"
#include "reference/depth/naive.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::depth {

namespace {

/// Only extreme points of the bodies can make extreme points of P.
polytope::Polytope hull_of_differences(std::span<const Vector> a, std::span<const Vector> b) {
  const polytope::Polytope hull_a = polytope::convex_hull(a), hull_b = polytope::convex_hull(b);
  std::vector<Vector> differences;
  differences.reserve(hull_a.vertices.size() * hull_b.vertices.size());
  for (const Vector& p : hull_a.vertices)
    for (const Vector& q : hull_b.vertices) differences.push_back(q - p);
  return polytope::convex_hull(differences);
}

/// The facet lies in the plane <normal, x> = this.
mpz_class offset(const polytope::Polytope& p, const polytope::Facet& facet) {
  return dot(facet.normal, p.vertices[p.corners[facet.begin]]);
}

NaiveDepth in_solid(const polytope::Polytope& p) {
  kernels::IdVector<polytope::FacetId, mpz_class> offsets;
  offsets.reserve(p.facets.size());
  for (const polytope::Facet& facet : p.facets) offsets.push_back(offset(p, facet));
  const mpz_class least = *std::ranges::min_element(offsets);
  if (least < 0) return {Status::disjoint, 0, {}};
  if (least == 0) return {Status::touching, 0, {}};

  NaiveDepth result{Status::penetrating, 0, {}};
  for (const polytope::FacetId i : p.facets.ids()) {
    const Vector& normal = p.facets[i].normal;
    const mpq_class squared = kernels::ratio(offsets[i] * offsets[i], dot(normal, normal));
    const bool first = result.directions.empty();
    if (!first && squared > result.squared) continue;
    if (!first && squared < result.squared) result.directions.clear();
    result.squared = squared;
    result.directions.push_back(normal);
  }
  std::ranges::sort(result.directions, lexicographically_less);
  return result;
}

/// The polygon's plane passes through O, and O is not to the right of an edge on facet 0's cycle.
bool polygon_contains_origin(const polytope::Polytope& p) {
  const polytope::Facet& front = p.facets.front();
  if (offset(p, front) != 0) return false;
  return std::ranges::all_of(p.edges, [&](const polytope::Edge& edge) {
    const Vector &from = p.vertices[edge.from], &to = p.vertices[edge.to];
    return det(from, to, front.normal) >= 0;  // the sense of the triangle O, from, to, seen from the normal's side
  });
}

bool segment_contains_origin(const polytope::Polytope& p) {
  const Vector &from = p.vertices.front(), &to = p.vertices.back();
  return is_zero(cross(from, to)) && dot(from, to) <= 0;
}

bool flat_contains_origin(const polytope::Polytope& p) {
  switch (p.rank) {
    case 0: return is_zero(p.vertices.front());
    case 1: return segment_contains_origin(p);
    default: return polygon_contains_origin(p);
  }
}

}  // namespace

NaiveDepth naive_depth(std::span<const Vector> a, std::span<const Vector> b) {
  const polytope::Polytope p = hull_of_differences(a, b);
  if (p.rank == 3) return in_solid(p);
  return {flat_contains_origin(p) ? Status::touching : Status::disjoint, 0, {}};
}

}  // namespace fathom::depth
