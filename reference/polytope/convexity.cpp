// SPDX-License-Identifier: GPL-3.0-or-later
// A closed surface of triangles, such that O lies strictly below all of them, a ray from O meets
// one only, and every two neighbours meet convexly, is the boundary of a convex body: seen from O
// it covers the sphere once, so it is star-shaped, and what is convex at every edge is convex
// (Mehlhorn et al., Checking geometric programs or verification of geometric structures, 1999).
#include "reference/polytope/convexity.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernels/filters/plane.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/rational.hpp"
#include "reference/polytope/hull.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

namespace {

using kernels::BoxedPoints;
using kernels::Plane;
using kernels::Sign;

/// Of equal points the first.
std::vector<std::uint32_t> first_of_equals(const std::vector<Vector>& points) {
  DistinctPoints distinct = no_points_yet(points, points.size());
  std::vector<std::uint32_t> canonical(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) canonical[i] = *distinct.insert(i).first;
  return canonical;
}

/// Whether each point, or an equal one, is a corner: others may lie outside the surface.
bool all_are_corners(std::span<const std::uint32_t> canonical, const std::vector<MeshTriangle>& triangles) {
  std::vector<bool> is_corner(canonical.size());
  for (const MeshTriangle& triangle : triangles)
    for (const std::uint32_t corner : triangle) is_corner[corner] = true;
  return std::ranges::all_of(canonical, [&](std::uint32_t i) { return is_corner[i]; });
}

/// A side of a triangle, and the corner opposite to it.
struct Side {
  std::uint32_t low, high;
  bool ascending;  ///< it runs from low to high
  std::uint32_t triangle, opposite;
};

/// All sides, those of one edge together.
std::vector<Side> sides_by_edge(std::span<const MeshTriangle> triangles) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), from < to, t, triangles[t][(i + 2) % 3]});
    }
  std::ranges::sort(sides, [](const Side& s, const Side& t) {
    return std::pair(s.low, s.high) != std::pair(t.low, t.high) ? std::pair(s.low, s.high) < std::pair(t.low, t.high)
                                                                : s.ascending < t.ascending;
  });
  return sides;
}

/// Whether each edge has two sides, which run in opposite senses.
bool in_pairs(const std::vector<Side>& sides) {
  if (sides.empty() || sides.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const Side &s = sides[i], &t = sides[i + 1];
    if (s.low != t.low || s.high != t.high || s.ascending == t.ascending) return false;
  }
  return true;
}

/// Whether the cone from `eye` over the triangle holds the point. The triangle is seen
/// counter-clockwise from the other side of its plane if `sign` is 1.
bool cone_holds(const BoxedPoints& points, std::uint32_t eye, const MeshTriangle& triangle, std::uint32_t point,
                int sign) {
  for (std::size_t i = 0; i < 3; ++i)
    if (sign * to_int(Plane(points, eye, triangle[i], triangle[(i + 1) % 3]).side(point)) < 0) return false;
  return true;
}

mpz_class six_volumes(const std::vector<Vector>& points, std::span<const MeshTriangle> triangles) {
  mpz_class sum;
  const Vector& origin = points.front();
  for (const auto& [p, q, r] : triangles) sum += det(points[p] - origin, points[q] - origin, points[r] - origin);
  return sum;
}

std::vector<MeshTriangle> triangles_of(const Polytope& hull) {
  std::vector<MeshTriangle> triangles;
  for (const Facet& facet : hull.facets)
    for (std::uint32_t i = facet.begin + 1; i + 1 < facet.end; ++i)
      triangles.push_back({hull.input_ids[hull.corners[facet.begin]], hull.input_ids[hull.corners[i]],
                           hull.input_ids[hull.corners[i + 1]]});
  return triangles;
}

struct HashOfVector {
  std::size_t operator()(const Vector& v) const { return hash_value(v); }
};

/// The hull's facets by their normals, with <normal, x> on their planes.
using Planes = std::unordered_map<Vector, mpz_class, HashOfVector>;

bool is_on_boundary(const Planes& planes, const std::vector<Vector>& points, const MeshTriangle& triangle) {
  const Vector& p = points[triangle[0]];
  const Vector normal = cross(points[triangle[1]] - p, points[triangle[2]] - p);
  if (is_zero(normal)) return true;
  const Vector unit = primitive(normal);
  for (const Vector& n : {unit, -unit}) {
    const auto plane = planes.find(n);
    if (plane != planes.end() && dot(n, p) == plane->second) return true;
  }
  return false;
}

/// Which point is deepest below all facets, and how deep. The facet that was nearest to one point
/// is tried first for the next.
std::optional<DeepestPoint> deepest_point(const Polytope& hull, const std::vector<Vector>& points,
                                          std::span<const std::uint32_t> canonical, std::size_t most_comparisons) {
  struct PlaneOfFacet {
    Vector normal;
    mpz_class height, square;
  };
  std::vector<PlaneOfFacet> planes;
  for (const Facet& facet : hull.facets)
    planes.push_back(
        {facet.normal, dot(facet.normal, hull.vertices[hull.corners[facet.begin]]), dot(facet.normal, facet.normal)});
  std::vector<bool> is_vertex(points.size());
  for (const std::uint32_t vertex : hull.input_ids) is_vertex[vertex] = true;
  DeepestPoint best;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (canonical[i] != i || is_vertex[i]) continue;
    mpq_class least = -1;  // of the squares so far
    for (std::size_t f = 0; f < planes.size() && (least < 0 || least > best.squared_depth); ++f) {
      if (most_comparisons-- == 0) return std::nullopt;
      const mpz_class below = planes[f].height - dot(planes[f].normal, points[i]);
      const mpq_class square = kernels::ratio(below * below, planes[f].square);
      if (least >= 0 && square >= least) continue;
      least = square;
      std::swap(planes[0], planes[f]);
    }
    if (least > best.squared_depth) best = {i, least};
  }
  return best;
}

MeshConvexity compared(const std::vector<Vector>& points, std::span<const std::uint32_t> canonical,
                       const std::vector<MeshTriangle>& triangles, const mpz_class& denominator,
                       std::size_t most_comparisons) {
  MeshConvexity found{true, std::nullopt};
  const Polytope hull = convex_hull(points);
  if (hull.rank < 3) return found;
  const Seam seam = seam_of(points, triangles);
  found.open = seam == Seam::open;
  Planes planes;
  for (const Facet& facet : hull.facets)
    planes.emplace(facet.normal, dot(facet.normal, hull.vertices[hull.corners[facet.begin]]));
  if (std::ranges::all_of(triangles, [&](const MeshTriangle& t) { return is_on_boundary(planes, points, t); }))
    return found;
  Dents& dents = found.dents.emplace();
  if (seam == Seam::closed) {
    const mpz_class of_mesh = abs(six_volumes(points, triangles)), of_hull = six_volumes(points, triangles_of(hull));
    if (of_mesh != 0 && of_mesh < of_hull) dents.volume_ratio = kernels::ratio(of_hull, of_mesh);
  }
  dents.deepest = deepest_point(hull, points, canonical, most_comparisons);
  if (dents.deepest) dents.deepest->squared_depth /= denominator * denominator;
  return found;
}

}  // namespace

std::vector<MeshTriangle> triangles_of(const MeshFaces& faces, std::span<const std::uint32_t> canonical) {
  std::vector<MeshTriangle> triangles;
  const auto add = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    const MeshTriangle triangle = {canonical[p], canonical[q], canonical[r]};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      triangles.push_back(triangle);
  };
  const std::vector<std::uint32_t>& corners = faces.corners;
  if (corners.empty() && faces.ends.empty())
    for (std::uint32_t i = 0; i + 2 < canonical.size(); i += 3) add(i, i + 1, i + 2);
  else if (faces.ends.empty())
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) add(corners[i], corners[i + 1], corners[i + 2]);
  std::size_t begin = 0;
  for (const std::uint32_t end : faces.ends) {
    for (std::size_t i = begin + 1; i + 1 < end; ++i) add(corners[begin], corners[i], corners[i + 1]);
    begin = end;
  }
  return triangles;
}

// A side is the step function that is 1 between its ends on the line through both, or -1 if it runs
// down. A sum of such functions vanishes if and only if all its jumps do.
Seam seam_of(std::span<const Vector> points, std::span<const MeshTriangle> triangles) {
  const std::vector<Side> sides = sides_by_edge(triangles);
  std::unordered_map<Vector, std::unordered_map<std::uint32_t, long>, HashOfVector> jumps;  // by lines' directions
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    const auto [low, high] = std::pair(sides[begin].low, sides[begin].high);
    long ascending = 0;
    for (; end < sides.size() && sides[end].low == low && sides[end].high == high; ++end)
      ascending += sides[end].ascending ? 1 : -1;
    if (ascending == 0) continue;
    Vector along = primitive(points[high] - points[low]);
    if (lexicographically_less(along, Vector())) along = -along;
    jumps[along][low] += ascending;
    jumps[along][high] -= ascending;
  }
  Seam seam = Seam::closed;
  for (const auto& [along, at_points] : jumps)
    for (const auto& [point, jump] : at_points) {
      if (jump % 2 != 0) return Seam::open;
      if (jump != 0) seam = Seam::even;
    }
  return seam;
}

bool is_convex_boundary(std::span<const Vector> given, std::span<const MeshTriangle> triangles) {
  const std::vector<Side> sides = sides_by_edge(triangles);
  if (!in_pairs(sides)) return false;
  // In twelfths the centroids of a triangle and of a tetrahedron are lattice points.
  std::vector<Vector> points;
  points.reserve(given.size() + 2);
  for (const Vector& p : given) points.push_back({12 * p.x, 12 * p.y, 12 * p.z});
  const auto [p, q, r] = triangles.front();
  points.emplace_back();
  points.emplace_back();
  const auto target = static_cast<std::uint32_t>(given.size()), eye = target + 1;
  const Vector sum = given[p] + given[q] + given[r];
  points[target] = {4 * sum.x, 4 * sum.y, 4 * sum.z};
  {
    const BoxedPoints boxed(points);
    const Plane first(boxed, p, q, r);
    if (first.degenerate()) return false;
    std::optional<std::uint32_t> apex;  // a corner off the first plane
    for (std::size_t t = 1; t < triangles.size() && !apex; ++t)
      for (const std::uint32_t corner : triangles[t])
        if (first.side(corner) != Sign::zero) apex = corner;
    if (!apex) return false;
    const Vector all = sum + given[*apex];
    points[eye] = {3 * all.x, 3 * all.y, 3 * all.z};
  }
  const BoxedPoints boxed(points);
  const int inside = to_int(Plane(boxed, p, q, r).side(eye));   // the same of all: -1 if they are seen from outside
  std::vector<std::pair<std::uint32_t, std::uint32_t>> across;  // for each edge a triangle and the corner behind it
  across.reserve(sides.size() / 2);
  for (std::size_t i = 0; i < sides.size(); i += 2) across.emplace_back(sides[i].triangle, sides[i + 1].opposite);
  std::ranges::sort(across);
  std::size_t next = 0;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Plane plane(boxed, triangles[t][0], triangles[t][1], triangles[t][2]);
    if (to_int(plane.side(eye)) != inside) return false;  // 0 if the triangle is degenerate
    for (; next < across.size() && across[next].first == t; ++next)
      if (to_int(plane.side(across[next].second)) == -inside) return false;
    if (t > 0 && cone_holds(boxed, eye, triangles[t], target, -inside)) return false;
  }
  return true;
}

std::optional<std::size_t> count_inner_points(std::span<const Point> body) {
  if (kernels::all_seen_extreme(body)) return 0;
  const std::optional<PlacedPair> placed = place_if_slim(body, body.first(1));
  if (!placed) return std::nullopt;
  const std::vector<Vector>& points = placed->a.points();
  const Polytope hull = convex_hull(points);
  DistinctPoints extreme = no_points_yet(points, hull.input_ids.size());
  extreme.insert(hull.input_ids.begin(), hull.input_ids.end());
  std::size_t inner = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) inner += !extreme.contains(i);
  return inner;
}

MeshConvexity mesh_convexity(std::span<const Point> points, const MeshFaces& faces, std::size_t most_comparisons) {
  if (points.empty()) throw std::invalid_argument("expected a point of a mesh, found none");
  const std::optional<PlacedPair> placed = place_if_slim(points, points.first(1));
  if (!placed) return {};
  const std::vector<Vector>& lattice = placed->a.points();
  const std::vector<std::uint32_t> canonical = first_of_equals(lattice);
  const std::vector<MeshTriangle> triangles = triangles_of(faces, canonical);
  if (triangles.empty()) return {};
  if (all_are_corners(canonical, triangles) && is_convex_boundary(lattice, triangles)) return {true, std::nullopt};
  return compared(lattice, canonical, triangles, placed->denominator, most_comparisons);
}

}  // namespace fathom::polytope
