// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/alignment.hpp"


#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::families {

namespace {

template <class Map>
Body mapped(Body body, Map map) {
  for (Point& p : body.points.edit()) p = map(p);
  return body;
}

}  // namespace

Features features(const Body& body) {
  const polytope::Polytope hull = polytope::convex_hull(polytope::place(body.points, body.points).a.points());
  const auto vertex = [&](polytope::VertexId v) { return body.points[hull.input_ids[v]]; };
  Features result;
  for (const polytope::VertexId v : hull.vertices.ids()) result.vertices.push_back(vertex(v));
  for (const polytope::Facet& facet : hull.facets) {
    result.normals.push_back(rational(facet.normal));
    std::vector<Point>& corners = result.facets.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(vertex(hull.corners[i]));
  }
  for (const polytope::Edge& edge : hull.edges) {
    result.edges.emplace_back(vertex(edge.from), vertex(edge.to));
    result.edge_directions.push_back(result.edges.back().second - result.edges.back().first);
    if (hull.rank == 3) result.arcs.emplace_back(rational(hull.facets[edge.left].normal), rational(hull.facets[edge.right].normal));
  }
  return result;
}

// x + (to' - from) <from, x> / <from, from>, where to' is the projection of `from` on `to`: takes `from` to to', and its determinant is
// cos^2 of the angle between the two.
Body edge_aligned(const Body& body, const Point& from, const Point& to) {
  const Point step = along(from, to) - from;
  const mpq_class square = dot(from, from);
  return mapped(body, [&](const Point& p) { return p + (dot(from, p) / square) * step; });
}

// The normals' map is the one of edge_aligned; the points' map is its inverse transposed: x - from <to' - from, x> / <from, to'>.
Body normal_aligned(const Body& body, const Point& from, const Point& to) {
  const Point target = along(from, to), step = target - from;
  const mpq_class scale = dot(from, target);
  return mapped(body, [&](const Point& p) { return p - (dot(step, p) / scale) * from; });
}

Point across(const Point& p, const Point& normal) { return p - along(p, normal); }

Point along(const Point& p, const Point& direction) { return (dot(p, direction) / dot(direction, direction)) * direction; }

mpq_class agreement(const Point& p, const Point& q) {
  const mpq_class cosine = dot(p, q);
  const mpq_class squared = cosine * cosine / (dot(p, p) * dot(q, q));
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
