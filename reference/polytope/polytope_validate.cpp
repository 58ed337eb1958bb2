// SPDX-License-Identifier: GPL-3.0-or-later
// Every law that polytope.hpp states, rank by rank. Nothing is assumed of the value, so shape and ranges of indices come first.
#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "reference/polytope/hull.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/polytope/validate_surface.hpp"

namespace fathom::polytope {
namespace {

using Index = std::uint32_t;

constexpr Index nowhere = std::numeric_limits<Index>::max();  // place of a vertex that a cycle does not have

void check_counts(const Polytope& p, kernels::Report& report) {
  const std::size_t v = p.vertices.size(), e = p.edges.size(), f = p.facets.size(), c = p.corners.size();
  switch (p.rank) {
    case 0: report.expect(v == 1 && e == 0 && f == 0 && c == 0, "a point has one vertex and nothing else"); break;
    case 1: report.expect(v == 2 && e == 1 && f == 0 && c == 0, "a segment has two vertices, one edge and no facet"); break;
    case 2: report.expect(v >= 3 && e == v && f == 2 && c == 2 * v, "a polygon has as many edges as vertices and two facets"); break;
    case 3: report.expect(v + f == e + 2 && c == 2 * e && f >= 4, "a solid has V - E + F = 2, and two facets at each edge"); break;
    default: report.expect(false, "rank is not 0, 1, 2 or 3");
  }
  report.expect(p.input_ids.size() == v, "there are not as many input ids as vertices");
}

void check_ranges(const Polytope& p, kernels::Report& report) {
  const auto vertex = [&](VertexId v) { return v.value < p.vertices.size(); };
  const auto facet = [&](FacetId f) { return p.rank == 1 ? f.is_none() : f.value < p.facets.size(); };
  for (const Edge& e : p.edges) {
    report.expect(vertex(e.from) && vertex(e.to) && e.from != e.to, "an edge has an end that is no vertex, or equal ends");
    report.expect(facet(e.left) && facet(e.right), "an edge refers to a facet that is none");
  }
  Index expected = 0;
  for (const Facet& f : p.facets) {
    const bool fits = f.begin == expected && f.end <= p.corners.size() && f.end >= f.begin && f.end - f.begin >= 3;
    if (!report.expect(fits, "a facet's corners do not follow those of the facet before, or are fewer than three")) return;
    expected = f.end;
  }
  report.expect(expected == p.corners.size(), "there are corners of no facet");
  report.expect(std::ranges::all_of(p.corners, vertex), "a corner is no vertex");
}

/// Vertices are input points, each under the lowest index that it has there.
void check_ids(const Polytope& p, std::span<const Vector> points, kernels::Report& report) {
  report.expect(std::ranges::adjacent_find(p.input_ids, std::greater_equal<>()) == p.input_ids.end(), "input ids do not ascend");
  DistinctPoints vertices = no_points_yet(points, p.vertices.size());
  for (const VertexId i : p.vertices.ids()) {
    const std::string name = "vertex " + std::to_string(i.value);
    const bool same = p.input_ids[i] < points.size() && points[p.input_ids[i]] == p.vertices[i];
    if (!report.expect(same, name + " is not the input point that it names")) continue;
    report.expect(vertices.insert(p.input_ids[i]).second, name + " repeats another vertex");
  }
  for (Index i = 0; i < points.size(); ++i) {
    const auto found = vertices.find(i);
    if (found != vertices.end()) report.expect(*found <= i, "input point " + std::to_string(i) + " equals a vertex and has a lower index");
  }
}

void check_segment(const Polytope& p, std::span<const Vector> points, kernels::Report& report) {
  const Vector &u = p.vertices.front(), &v = p.vertices.back();
  const auto inside = [&](const Vector& q) { return is_zero(cross(v - u, q - u)) && dot(q - u, q - v) <= 0; };
  report.expect(std::ranges::all_of(points, inside), "an input point lies outside the segment");
}

/// Facet 1 is facet 0 seen from behind, and the edges are facet 0's sides.
void check_polygon(const Polytope& p, std::span<const Vector> points, kernels::Report& report) {
  const auto n = static_cast<Index>(p.vertices.size());
  const auto slot_of = [&](Index begin) {
    kernels::IdVector<VertexId, Index> slots(n, nowhere);
    for (Index i = 0; i < n; ++i) slots[p.corners[begin + i]] = i;
    return slots;
  };
  if (!report.expect(p.facets.front().end == n, "the two facets of a polygon differ in size")) return;
  const kernels::IdVector<VertexId, Index> front = slot_of(0), back = slot_of(n);
  report.expect(p.facets.back().normal == -p.facets.front().normal, "the normals of a polygon's facets are not opposite");
  for (Index i = 0; i < n; ++i) {
    const VertexId u = p.corners[i], v = p.corners[(i + 1) % n];
    const bool reversed = back[u] != nowhere && back[v] != nowhere && (back[v] + 1) % n == back[u];
    report.expect(reversed, "a side of a polygon's facet 0 is not, reversed, one of facet 1");
  }
  kernels::IdVector<VertexId, bool> used(n);
  for (const Edge& e : p.edges) {
    const bool side =
        front[e.from] != nowhere && p.corners[(front[e.from] + 1) % n] == e.to && e.left == FacetId(0) && e.right == FacetId(1);
    if (report.expect(side, "a polygon's edge does not run along facet 0 with facet 0 to its left")) {
      report.expect(!used[e.from], "a polygon's edge occurs twice");
      used[e.from] = true;
    }
  }
  const Facet& f = p.facets.front();
  const bool planar = std::ranges::all_of(points, [&](const Vector& q) { return dot(f.normal, q - p.vertices.front()) == 0; });
  report.expect(planar, "an input point lies off the polygon's plane");
}

/// Whether the half-space or, for a polygon, the half-plane of any facet or side leaves an input point outside.
void check_containment(const Polytope& p, std::span<const Vector> points, kernels::Report& report) {
  const auto expect_none_beyond = [&](const Vector& n, const Vector& base, const std::string& name) {
    const mpz_class height = dot(n, base);
    const bool none = std::ranges::none_of(points, [&](const Vector& q) { return dot(n, q) > height; });
    report.expect(none, "an input point lies beyond " + name);
  };
  if (p.rank == 2) {
    for (std::size_t i = 0; i < p.edges.size(); ++i) {
      const Vector& from = p.vertices[p.edges[i].from];
      expect_none_beyond(cross(p.vertices[p.edges[i].to] - from, p.facets.front().normal), from, "side " + std::to_string(i));
    }
  } else if (p.rank == 3) {
    for (const FacetId i : p.facets.ids()) {
      expect_none_beyond(p.facets[i].normal, p.vertices[p.corners[p.facets[i].begin]], "facet " + std::to_string(i.value));
    }
  }
}

}  // namespace

kernels::Report validate(const Polytope& polytope, std::span<const Vector> points, bool thorough) {
  kernels::Report report;
  check_counts(polytope, report);
  if (report.ok()) check_ranges(polytope, report);
  if (!report.ok()) return report;
  check_ids(polytope, points, report);
  validate_facets(polytope, report);
  if (polytope.rank == 0) {
    report.expect(std::ranges::all_of(points, [&](const Vector& q) { return q == polytope.vertices.front(); }),
                  "input points differ from the one vertex");
  }
  if (polytope.rank == 1) check_segment(polytope, points, report);
  if (polytope.rank == 2) check_polygon(polytope, points, report);
  if (polytope.rank == 3) validate_surface(polytope, report);
  if (thorough) check_containment(polytope, points, report);
  return report;
}

}  // namespace fathom::polytope
