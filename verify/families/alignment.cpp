// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/alignment.hpp"

#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::families {

namespace {

Point as_point(const Vector& v) { return {v.x, v.y, v.z}; }

template <class Map>
Body mapped(Body body, Map map) {
  for (Point& p : body.points.edit()) p = map(p);
  return body;
}

}  // namespace

mpq_class inner(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

Point combined(const mpq_class& s, const Point& p, const mpq_class& t, const Point& q) {
  return {mpq_class(s * p.x + t * q.x), mpq_class(s * p.y + t * q.y), mpq_class(s * p.z + t * q.z)};
}

Point crossed(const Point& p, const Point& q) {
  return {mpq_class(p.y * q.z - p.z * q.y), mpq_class(p.z * q.x - p.x * q.z), mpq_class(p.x * q.y - p.y * q.x)};
}

Features features(const Body& body) {
  const polytope::Polytope hull = polytope::convex_hull(polytope::place(body.points, body.points).a.points());
  const auto vertex = [&](polytope::VertexId v) { return body.points[hull.input_ids[v]]; };
  Features result;
  for (const polytope::VertexId v : hull.vertices.ids()) result.vertices.push_back(vertex(v));
  for (const polytope::Facet& facet : hull.facets) {
    result.normals.push_back(as_point(facet.normal));
    std::vector<Point>& corners = result.facets.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(vertex(hull.corners[i]));
  }
  for (const polytope::Edge& edge : hull.edges) {
    result.edges.emplace_back(vertex(edge.from), vertex(edge.to));
    result.edge_directions.push_back(combined(1, result.edges.back().second, -1, result.edges.back().first));
    if (hull.rank == 3) result.arcs.emplace_back(as_point(hull.facets[edge.left].normal), as_point(hull.facets[edge.right].normal));
  }
  return result;
}

// x + (to' - from) <from, x> / <from, from>, where to' is the projection of `from` on `to`: takes `from` to to', and its determinant is
// cos^2 of the angle between the two.
Body edge_aligned(const Body& body, const Point& from, const Point& to) {
  const Point step = combined(1, along(from, to), -1, from);
  const mpq_class square = inner(from, from);
  return mapped(body, [&](const Point& p) { return combined(1, p, mpq_class(inner(from, p) / square), step); });
}

// The normals' map is the one of edge_aligned; the points' map is its inverse transposed: x - from <to' - from, x> / <from, to'>.
Body normal_aligned(const Body& body, const Point& from, const Point& to) {
  const Point target = along(from, to), step = combined(1, target, -1, from);
  const mpq_class scale = inner(from, target);
  return mapped(body, [&](const Point& p) { return combined(1, p, mpq_class(-inner(step, p) / scale), from); });
}

Point across(const Point& p, const Point& normal) { return combined(1, p, -1, along(p, normal)); }

Point along(const Point& p, const Point& direction) {
  return combined(mpq_class(inner(p, direction) / inner(direction, direction)), direction, 0, direction);
}

mpq_class agreement(const Point& p, const Point& q) {
  const mpq_class cosine = inner(p, q);
  const mpq_class squared = cosine * cosine / (inner(p, p) * inner(q, q));
  return sgn(cosine) < 0 ? mpq_class(-squared) : squared;
}

std::optional<std::pair<std::size_t, std::size_t>> best_agreement(const std::vector<Point>& p, const std::vector<Point>& q) {
  std::optional<std::pair<std::size_t, std::size_t>> best;
  mpq_class most = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      if (const mpq_class here = agreement(p[i], q[j]); here > most) {
        most = here;
        best = {i, j};
      }
  return best;
}

}  // namespace fathom::families
