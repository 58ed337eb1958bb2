// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "view/picture/drawn.hpp"

namespace fathom::picture {
namespace {

/// The looks from p + t (q - p) lie on the inner side of a facet as far as s = at + slope t, or from there on.
struct Reach {
  mpq_class at, slope;

  [[nodiscard]] mpq_class value(const mpq_class& t) const { return at + slope * t; }
};

/// The strip of looks from a segment, cut by the facets of a body: the points of it with t in [from, to] and s between the least `above`
/// and the greatest `below`.
struct Strip {
  mpq_class from = 0, to = 1;
  std::vector<Reach> below{{0, 0}}, above;  // looks begin at s = 0

  /// The least t after which the strip is not empty. The height of the strip is concave in t: so where it is not positive, the two facets
  /// that bound it there say where it may become so.                                                             [Newton's method]
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
  /// Of the reaches the least at t, and just after it, if `sign` is 1; the greatest if it is -1.
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
    sides_.push_back(
        {normal, dot(normal, points[hull.input_ids[hull.corners[facet.begin]]]), from_its_edge ? mpq_class(0) : dot(normal, view.look())});
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

}  // namespace fathom::picture
