// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/drawn.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/shapes/core.hpp"

namespace fathom::picture {
namespace {

/// An end of the lines of sight from p + t (q - p) at a facet: they are on its inner side up to s =
/// at + slope t, or from there on.
struct Reach {
  mpq_class at, slope;

  [[nodiscard]] mpq_class value(const mpq_class& t) const { return at + slope * t; }
};

/// The strip of the lines of sight from a segment, cut by the facets of a body: the points with t
/// in [from, to] and s between the greatest `below` and the least `above`.
struct Strip {
  mpq_class from = 0, to = 1;
  std::vector<Reach> below{{0, 0}}, above;  // lines of sight begin at s = 0

  /// Returns the least t after which the strip is not empty. The height of the strip is concave in
  /// t; if it is not positive, the two facets that bound it at t determine the next t.
  /// [Newton's method]
  [[nodiscard]] std::optional<mpq_class> begin() const {
    if (above.empty()) return std::nullopt;
    for (mpq_class t = from; t < to;) {
      const Reach low = tightest(below, t, -1), high = tightest(above, t, 1);
      const mpq_class height = high.value(t) - low.value(t), slope = high.slope - low.slope;
      if (height > 0 || (height == 0 && slope > 0)) return t;
      if (slope <= 0) return std::nullopt;
      t -= height / slope;
    }
    return std::nullopt;
  }

 private:
  /// Returns the reach that is least at t, and just after it, if `sign` is 1; the greatest if it is
  /// -1.
  static Reach tightest(const std::vector<Reach>& reaches, const mpq_class& t, int sign) {
    const Reach* best = nullptr;
    mpq_class value;
    for (const Reach& reach : reaches) {
      const mpq_class here = reach.value(t);
      const int order = best ? sign * cmp(here, value) : -1;
      if (order < 0 || (order == 0 && sign * cmp(reach.slope, best->slope) < 0)) best = &reach, value = here;
    }
    return *best;
  }
};

Point between(const Point& p, const Point& q, const mpq_class& t) { return p + t * (q - p); }

/// Returns the point of the boundary that is nearest to O.
Point foot(const HalfSpace& half) { return (half.offset / dot(half.normal, half.normal)) * half.normal; }

std::vector<Dot> half_plane(const HalfSpace& half, const Window& window, const Point& by) {
  const double width = window.size().width, height = window.size().height;
  if (window.view().towards().x == 0 && window.view().towards().y == 0) {  // upon the plane
    const Dot on = window.dot(foot(half) + by), along = window.shift({mpq_class(-half.normal.y), half.normal.x, 0});
    if (!std::isfinite(on.x) || !std::isfinite(on.y)) return {};
    return beside({{-width, -height}, {2 * width, -height}, {2 * width, 2 * height}, {-width, 2 * height}}, on,
                  {-along.x, -along.y});
  }
  const double at = std::clamp(window.dot(foot(half) + by).x, -width, 2 * width);
  const double end = window.shift(half.normal).x > 0 ? -width : 2 * width;
  if (at == end) return {};
  return {{at, -height}, {at, 2 * height}, {end, 2 * height}, {end, -height}};
}

Bounds2 box_of(const Wires& wires, const View& view) {
  Bounds2 result = Bounds2::of(view.place(wires.corners.front()));
  for (const Point& corner : wires.corners) result.add(view.place(corner));
  return result;
}

/// Returns nullopt if the hull would take too much memory, as with too many different denominators.
std::optional<polytope::Polytope> hull_of(const std::vector<Point>& points) {
  try {
    return polytope::hull_of(points);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Wires wires_on(const std::vector<Point>& points, const std::optional<polytope::Polytope>& hull, const View& view) {
  Wires result;
  if (!hull) {
    result.corners = points;
    return result;
  }
  for (const std::uint32_t id : hull->input_ids) result.corners.push_back(points[id]);
  kernels::IdVector<polytope::FacetId, bool> faces_us;
  for (const polytope::Facet& facet : hull->facets) faces_us.push_back(view.faces_us(facet.normal));
  const auto seen = [&](polytope::FacetId f) { return f.is_none() || faces_us[f]; };
  for (const polytope::Edge& edge : hull->edges) {
    const bool left = seen(edge.left), right = seen(edge.right);
    const bool hidden = !left && !right && hull->rank == 3;  // a polygon, even seen from its edge, hides nothing
    if (hull->edges.size() > (hidden ? most_hidden : most_edges) && left == right) continue;
    result.wires.push_back({points[hull->input_ids[edge.from]], points[hull->input_ids[edge.to]], hidden});
  }
  return result;
}

/// Splits the edges of each piece where other pieces hide them.
void hide_by_others(std::vector<Wires>& pieces, const std::vector<std::optional<Cover>>& covers) {
  for (std::size_t own = 0; own < pieces.size(); ++own) {
    std::vector<const Cover*> others;
    for (std::size_t i = 0; i < covers.size(); ++i)
      if (i != own && covers[i]) others.push_back(&*covers[i]);
    pieces[own].wires = behind(pieces[own].wires, others);
  }
}

void erase_hidden(Wires& piece) {
  std::erase_if(piece.wires, [](const Wires::Wire& wire) { return wire.hidden; });
}

}  // namespace

Cover::Cover(const std::vector<Point>& points, const polytope::Polytope& hull, const View& view)
    : view_(&view), box_(Bounds2::of(view.place(points.front()))), nearest_(dot(view.look(), points.front())) {
  for (const std::uint32_t id : hull.input_ids) {
    box_.add(view.place(points[id]));
    nearest_ = std::max(nearest_, dot(view.look(), points[id]));
  }
  for (const polytope::Facet& facet : hull.facets) {
    const Point normal = rational(facet.normal);
    const bool from_its_edge = view.faces_us(facet.normal) && view.faces_us(-facet.normal);
    sides_.push_back({normal, dot(normal, points[hull.input_ids[hull.corners[facet.begin]]]),
                      from_its_edge ? mpq_class(0) : dot(normal, view.look())});
  }
}

bool Cover::may_hide(const Point& p, const Point& q) const {
  Bounds2 box = Bounds2::of(view_->place(p));
  box.add(view_->place(q));
  return box.low.x <= box_.high.x && box_.low.x <= box.high.x && box.low.y <= box_.high.y && box_.low.y <= box.high.y &&
         std::min(dot(view_->look(), p), dot(view_->look(), q)) < nearest_;
}

std::optional<HiddenPart> Cover::hides(const Point& p, const Point& q) const {
  if (!may_hide(p, q)) return std::nullopt;
  const Point along = q - p;
  Strip strip, back;  // from q to p
  for (const Side& side : sides_) {
    const mpq_class turn = dot(side.normal, along), room = side.offset - dot(side.normal, p);
    if (side.towards == 0) {
      if (turn == 0 && room <= 0) return std::nullopt;
      if (turn > 0) strip.to = std::min(strip.to, mpq_class(room / turn));
      if (turn < 0) strip.from = std::max(strip.from, mpq_class(room / turn));
      continue;
    }
    const Reach reach{mpq_class(room / side.towards), mpq_class(-turn / side.towards)};
    (side.towards > 0 ? strip.above : strip.below).push_back(reach);
    (side.towards > 0 ? back.above : back.below).push_back({reach.value(1), mpq_class(-reach.slope)});
  }
  back.from = 1 - strip.to;
  back.to = 1 - strip.from;
  const std::optional<mpq_class> first = strip.begin(), last = first ? back.begin() : std::nullopt;
  if (!last) return std::nullopt;
  return HiddenPart{*first, mpq_class(1 - *last)};
}

std::vector<Wires::Wire> behind(const std::vector<Wires::Wire>& wires, const std::vector<const Cover*>& covers) {
  std::vector<Wires::Wire> result;
  for (const Wires::Wire& wire : wires) {
    std::vector<HiddenPart> hidden;
    if (!wire.hidden)
      for (const Cover* cover : covers)
        if (std::optional<HiddenPart> part = cover->hides(wire.from, wire.to)) hidden.push_back(*std::move(part));
    std::ranges::sort(hidden, {}, &HiddenPart::from);
    mpq_class reached = 0;
    const auto add = [&](const mpq_class& from, const mpq_class& to, bool is_hidden) {
      if (from < to) result.push_back({between(wire.from, wire.to, from), between(wire.from, wire.to, to), is_hidden});
    };
    for (const HiddenPart& part : hidden) {
      add(reached, part.from, wire.hidden);
      add(std::max(reached, part.from), part.to, true);
      reached = std::max(reached, part.to);
    }
    add(reached, 1, wire.hidden);
  }
  return result;
}

Wires wires_of(const std::vector<Point>& points, const View& view) { return wires_on(points, hull_of(points), view); }

Drawn drawn_shape(const Shape& shape, const View& view) {
  if (const auto* half = std::get_if<HalfSpace>(&shape.core)) {
    const Point out = shape.radius * exact_point(unit_vector(half->normal));
    return HalfSpace{half->normal, mpq_class(half->offset + dot(half->normal, out))};
  }
  const Shape simple = shapes::simplified(shape);
  if (simple.radius == 0)
    if (const auto points = shapes::polytope_points(simple, most_expanded_points)) return wires_of(*points, view);
  const auto& terms = std::get<std::vector<Term>>(simple.core);
  return Curved{terms, simple.radius, simple.radius == 0 ? rims_of(terms, view) : std::vector<Rim>{}};
}

Compound compound_of(const std::vector<std::vector<Point>>& pieces, const View& view) {
  Compound result;
  std::vector<std::optional<Cover>> covers;
  std::size_t hidden = 0, all = 0;
  for (const std::vector<Point>& piece : pieces) {
    const std::optional<polytope::Polytope> hull = hull_of(piece);
    covers.push_back(hull ? std::optional<Cover>(std::in_place, piece, *hull, view) : std::nullopt);
    const Wires& made = result.pieces.emplace_back(wires_on(piece, hull, view));
    all += made.wires.size();
    hidden += static_cast<std::size_t>(std::ranges::count(made.wires, true, &Wires::Wire::hidden));
  }
  if (all > most_hidden) std::ranges::for_each(result.pieces, erase_hidden);
  if (all - hidden > most_edges) {
    for (Wires& piece : result.pieces) piece.wires.clear();
    return result;
  }
  hide_by_others(result.pieces, covers);
  if (all > most_hidden) std::ranges::for_each(result.pieces, erase_hidden);
  return result;
}

std::optional<Bounds2> box_of(const Drawn& body, const View& view) {
  if (const auto* curved = std::get_if<Curved>(&body)) return curved_box(*curved, view);
  if (const auto* compound = std::get_if<Compound>(&body)) {
    Bounds2 result = box_of(compound->pieces.front(), view);
    for (const Wires& piece : compound->pieces) result.add(box_of(piece, view));
    return result;
  }
  if (const auto* wires = std::get_if<Wires>(&body)) return box_of(*wires, view);
  return std::nullopt;
}

std::vector<std::vector<Dot>> silhouettes(const Drawn& body, const Window& window, const Point& by) {
  if (const auto* wires = std::get_if<Wires>(&body)) return {window.hull(wires->corners, by)};
  if (const auto* curved = std::get_if<Curved>(&body)) return {curved_outline(*curved, window, by)};
  if (const auto* half = std::get_if<HalfSpace>(&body)) return {half_plane(*half, window, by)};
  std::vector<std::vector<Dot>> result;
  for (const Wires& piece : std::get<Compound>(body).pieces) result.push_back(window.hull(piece.corners, by));
  return result;
}

}  // namespace fathom::picture
