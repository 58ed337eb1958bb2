// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/drawn.hpp"

#include <algorithm>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/shapes/core.hpp"
#include "view/picture/curved.hpp"

namespace fathom::picture {
namespace {

constexpr std::size_t most_hidden = 200;  // edges of a body that shows those behind it too
constexpr std::size_t most_edges = 600;   // of one that shows more than its outline

/// A point of the boundary.
Point foot(const HalfSpace& half) { return scaled(half.normal, mpq_class(half.offset / product(half.normal, half.normal))); }

std::vector<Dot> half_plane(const HalfSpace& half, const Window& window, const Point& by) {
  const double width = window.size().width, height = window.size().height;
  const double at = std::clamp(window.dot(sum(foot(half), by)).x, -width, 2 * width);
  const double end = window.shift(half.normal).x > 0 ? -width : 2 * width;
  if (at == end) return {};
  return {{at, -height}, {at, 2 * height}, {end, 2 * height}, {end, -height}};
}

}  // namespace

Wires wires_of(const std::vector<Point>& points, const View& view) {
  Wires result;
  polytope::Polytope hull;
  try {
    hull = polytope::convex_hull(polytope::place(points, points).a.points());
  } catch (const InputError&) {  // too many different denominators
    result.corners = points;
    return result;
  }
  for (const std::uint32_t id : hull.input_ids) result.corners.push_back(points[id]);
  kernels::IdVector<polytope::FacetId, bool> faces_us;
  for (const polytope::Facet& facet : hull.facets) faces_us.push_back(view.faces_us(facet.normal));
  const auto seen = [&](polytope::FacetId f) { return f.is_none() || faces_us[f]; };
  for (const polytope::Edge& edge : hull.edges) {
    const bool left = seen(edge.left), right = seen(edge.right);
    const bool hidden = !left && !right && hull.rank == 3;  // a polygon, even seen from its edge, hides nothing
    if (hull.edges.size() > (hidden ? most_hidden : most_edges) && left == right) continue;
    result.wires.push_back({points[hull.input_ids[edge.from]], points[hull.input_ids[edge.to]], hidden});
  }
  return result;
}

Drawn drawn_shape(const Shape& shape, const View& view) {
  if (const auto* half = std::get_if<HalfSpace>(&shape.core)) {
    const Point out = scaled(exact_point(unit_vector(half->normal)), shape.radius);
    return HalfSpace{half->normal, mpq_class(half->offset + product(half->normal, out))};
  }
  const Shape simple = shapes::simplified(shape);
  if (simple.radius == 0)
    if (const auto points = shapes::polytope_points(simple, most_expanded_points)) return wires_of(*points, view);
  return Curved{std::get<std::vector<Term>>(simple.core), simple.radius};
}

std::optional<Bounds2> box_of(const Drawn& body, const View& view) {
  if (const auto* curved = std::get_if<Curved>(&body)) return curved_box(*curved, view);
  const auto* wires = std::get_if<Wires>(&body);
  if (!wires) return std::nullopt;
  Bounds2 result = Bounds2::of(view.place(wires->corners.front()));
  for (const Point& corner : wires->corners) result.add(view.place(corner));
  return result;
}

std::vector<Dot> silhouette(const Drawn& body, const Window& window, const Point& by) {
  if (const auto* wires = std::get_if<Wires>(&body)) return window.hull(wires->corners, by);
  if (const auto* curved = std::get_if<Curved>(&body)) return curved_outline(*curved, window, by);
  return half_plane(std::get<HalfSpace>(body), window, by);
}

}  // namespace fathom::picture
