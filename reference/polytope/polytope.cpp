// SPDX-License-Identifier: GPL-3.0-or-later
// The hull of points of any rank: duplicates out, rank found exactly, then one method for each rank.
#include "reference/polytope/polytope.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "kernels/float_environment.hpp"
#include "reference/polytope/hull.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

/// One index, the lowest, of each group of equal points; ascending.
std::vector<Index> distinct_points(std::span<const Vector> points) {
  DistinctPoints seen = no_points_yet(points, points.size());
  std::vector<Index> ids;
  for (Index i = 0; i < points.size(); ++i) {
    if (seen.insert(i).second) ids.push_back(i);
  }
  return ids;
}

Polytope point(std::span<const Vector> points) {
  Polytope polytope;
  polytope.vertices = {points[0]};
  polytope.input_ids = {0};
  return polytope;
}

/// Lexicographic order is monotone along a line.
Polytope segment(std::span<const Vector> points, std::span<const Index> ids) {
  const auto [first, last] =
      std::ranges::minmax_element(ids, [&](Index i, Index j) { return lexicographically_less(points[i], points[j]); });
  const auto [low, high] = std::minmax(*first, *last);
  Polytope polytope;
  polytope.rank = 1;
  polytope.vertices = {points[low], points[high]};
  polytope.input_ids = {low, high};
  polytope.edges = {{VertexId(0), VertexId(1), FacetId::none(), FacetId::none()}};
  return polytope;
}

/// Of the two normals the one whose first component other than zero is positive belongs to facet 0; seen along that axis nothing is lost.
Polytope polygon(std::span<const Vector> points, std::span<const Index> ids, const Vector& some_normal) {
  Vector normal = primitive(some_normal);
  const int axis = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
  if (lexicographically_less(normal, Vector{})) normal = -normal;
  const std::vector<Index> corners = hull_cycle(points, ids, axis);

  Polytope polytope;
  polytope.rank = 2;
  std::vector<bool> extreme(points.size());
  for (const Index id : corners) extreme[id] = true;
  const std::vector<VertexId> number = number_vertices(polytope, points, extreme);
  std::vector<VertexId> cycle;
  for (const Index id : corners) cycle.push_back(number[id]);
  start_at_lowest(cycle);
  append_facet(polytope, normal, cycle);
  std::reverse(cycle.begin() + 1, cycle.end());
  append_facet(polytope, -normal, cycle);
  const auto n = static_cast<Index>(cycle.size());
  for (Index i = 0; i < n; ++i) polytope.edges.push_back({polytope.corners[i], polytope.corners[(i + 1) % n], FacetId(0), FacetId(1)});
  return polytope;
}

}  // namespace

int affine_rank(std::span<const Vector> points) { return affine_span<mpz_class>(points, points.size()).rank; }

Polytope convex_hull(std::span<const Vector> points) {
  const kernels::DefaultFloatEnvironment environment;
  if (points.empty()) throw std::invalid_argument("convex_hull: no points");
  if (points.size() > std::numeric_limits<std::int32_t>::max()) throw std::invalid_argument("convex_hull: more than 2^31 - 1 points");
  const std::vector<Index> ids = distinct_points(points);
  const Span<mpz_class> span = affine_span<mpz_class>(points, points.size());
  switch (span.rank) {
    case 0: return point(points);
    case 1: return segment(points, ids);
    case 2: return polygon(points, ids, span.normal);
    default: return merge_coplanar(points, ids.size() <= few_points ? hull_triangles_of_few(points, ids) : hull_triangles(points, ids));
  }
}

}  // namespace fathom::polytope
