// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/pair_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fathom/numbers.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"
#include "view/picture/wires.hpp"

namespace fathom::picture {
namespace {

Point sum(const Point& p, const Point& q) { return {mpq_class(p.x + q.x), mpq_class(p.y + q.y), mpq_class(p.z + q.z)}; }
Point scaled(const Point& p, const mpq_class& by) { return {mpq_class(p.x * by), mpq_class(p.y * by), mpq_class(p.z * by)}; }
mpq_class size(const Point& p) { return std::max({mpq_class(abs(p.x)), mpq_class(abs(p.y)), mpq_class(abs(p.z))}); }
bool is_zero(const Point& p) { return p.x == 0 && p.y == 0 && p.z == 0; }

/// What both pictures of a pair share.
struct Subject {
  const Pair& pair;
  Point anchor;                  // where the translations begin
  Point moved;                   // the true translation, or that of disjoint bodies until they touch; may be zero
  std::optional<Point> claimed;  // cut where it is out of all proportion
  bool cut = false;
  mpq_class extent;  // of the whole pair, positive
  View view;
  Wires a, b;
};

mpq_class extent_of(const Pair& pair) {
  mpq_class result = 0;
  for (const auto* body : {&pair.a, &pair.b})
    for (const Point& p : *body) result = std::max(result, size(sum(p, scaled(pair.b.front(), -1))));
  return result == 0 ? mpq_class(1) : result;
}

View view_of(const Depth& depth, const Point& moved, const std::optional<Point>& claimed) {
  const std::optional<Point> second = claimed && !is_zero(*claimed) ? claimed : std::nullopt;
  if (!is_zero(moved)) return {moved, second};
  return {point_of(depth.direction()), second};
}

Subject subject_of(const Pair& pair, std::optional<Point> claimed) {
  const Depth& depth = pair.depth;
  const std::optional<Witness> witness = depth.distance() ? std::optional(depth.distance()->witness) : depth.witness();
  const Point moved = depth.distance() ? depth.distance()->translation : depth.translation();
  const mpq_class extent = extent_of(pair), longest = 3 * extent;
  const bool cut = claimed && size(*claimed) > longest;
  if (cut) claimed = scaled(*claimed, mpq_class(longest / size(*claimed)));
  const View view = view_of(depth, moved, claimed);
  const polytope::PlacedPair placed = polytope::place(pair.a, pair.b);
  return {pair,
          witness ? witness->a : pair.b.front(),
          moved,
          claimed,
          cut,
          extent,
          view,
          wires_of(polytope::convex_hull(placed.a.points()), view),
          wires_of(polytope::convex_hull(placed.b.points()), view)};
}

/// One of the pictures: places of the plane in multiples of a unit around a centre, and the frame that shows them.
struct Panel {
  const Subject& subject;
  Point centre;
  mpq_class unit;
  Viewport frame{{0, 0}, 1};

  [[nodiscard]] Dot dot(const Point& p) const { return subject.view.project(p, centre, unit); }
  [[nodiscard]] std::vector<Dot> dots(const std::vector<Point>& points) const {
    std::vector<Dot> result;
    for (const Point& p : points) result.push_back(dot(p));
    return result;
  }
};

std::string path_element(const std::string& style, const std::string& d) {
  return d.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>", style, d);
}

/// A body's area, then its wires: hidden ones first.
std::string body_elements(const Panel& panel, const std::vector<Point>& points, const Wires& wires, const std::string& style) {
  const std::vector<Dot> dots = panel.dots(points);
  std::vector<Dot> corners;
  for (const std::uint32_t i : wires.corners) corners.push_back(dots[i]);
  const std::vector<Dot> around = outline(corners);
  std::string hidden, seen;
  for (const Wires::Wire& wire : wires.wires) (wire.hidden ? hidden : seen) += panel.frame.path({dots[wire.from], dots[wire.to]}, false);
  std::string result = path_element(style + " area", panel.frame.path(around, true)) + path_element(style + " hidden", hidden) +
                       path_element(style + " wire", seen);
  if (wires.corners.size() == 1) {
    const Dot at = panel.frame.pixel(corners.front());
    result += fmt::format("<circle class=\"{} dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"/>", style, at.x, at.y);
  }
  return result;
}

/// The outline of A after a translation.
std::string ghost_element(const Panel& panel, const Point& by) {
  std::vector<Dot> corners;
  for (const std::uint32_t i : panel.subject.a.corners) corners.push_back(panel.dot(sum(panel.subject.pair.a[i], by)));
  return path_element("ghost", panel.frame.path(outline(corners), true));
}

/// An arrow from the anchor; a dot if it is too short to see.
std::string arrow_elements(const Panel& panel, const Point& by, const std::string& style) {
  const Dot from = panel.frame.pixel(panel.dot(panel.subject.anchor)), to = panel.frame.pixel(panel.dot(sum(panel.subject.anchor, by)));
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length >= 2)) return fmt::format("<circle class=\"{} dot\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>", style, from.x, from.y);
  const double head = std::min(9.0, length / 2), x = (to.x - from.x) / length * head, y = (to.y - from.y) / length * head;
  return fmt::format(
      "<path class=\"{0} shaft\" d=\"M{1:.1f} {2:.1f}L{3:.1f} {4:.1f}\"/><path class=\"{0} head\" d=\"M{5:.1f} {6:.1f}L{7:.1f} "
      "{8:.1f}L{9:.1f} {10:.1f}Z\"/>",
      style, from.x, from.y, to.x - x * 0.7, to.y - y * 0.7, to.x, to.y, to.x - x - y * 0.4, to.y - y + x * 0.4, to.x - x + y * 0.4,
      to.y - y - x * 0.4);
}

/// The body's letter, in the middle of what is seen of it.
std::string letter_element(const Panel& panel, const std::vector<Point>& points, const Wires& wires, const std::string& style,
                           const std::string& letter) {
  std::vector<Dot> corners;
  for (const std::uint32_t i : wires.corners) corners.push_back(panel.frame.pixel(panel.dot(points[i])));
  const std::vector<Dot> around =
      clipped(outline(corners), true, {Viewport::width / 2, Viewport::height / 2}, {Viewport::width / 2 - 12, Viewport::height / 2 - 12});
  if (around.empty()) return "";
  Dot middle;
  for (const Dot& d : around)
    middle = {middle.x + d.x / static_cast<double>(around.size()), middle.y + d.y / static_cast<double>(around.size())};
  return fmt::format("<text class=\"{} letter\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", style, middle.x, middle.y, letter);
}

std::string panel_svg(const Panel& panel, const std::string& name, const std::string& label, const std::string& description) {
  const Subject& s = panel.subject;
  std::string body = body_elements(panel, s.pair.b, s.b, "body-b") + body_elements(panel, s.pair.a, s.a, "body-a");
  if (!is_zero(s.moved)) body += ghost_element(panel, s.moved);
  body += letter_element(panel, s.pair.a, s.a, "body-a", "A") + letter_element(panel, s.pair.b, s.b, "body-b", "B");
  if (!is_zero(s.moved)) body += arrow_elements(panel, s.moved, "true");
  if (s.claimed) body += arrow_elements(panel, *s.claimed, "claimed");
  return fmt::format(
      "<svg class=\"pair\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" aria-labelledby=\"{2}-t {2}-d\">"
      "<title id=\"{2}-t\">{3}</title><desc id=\"{2}-d\">{4}</desc>{5}</svg>\n",
      Viewport::width, Viewport::height, name, label, description, body);
}

std::string description_of(const Subject& s) {
  std::string result = "Orthographic view of the hulls of A and B across the true translation of A, which points to the right.";
  if (is_zero(s.moved)) result = "Orthographic view of the hulls of A and B along a plane that separates them; no translation is needed.";
  if (s.pair.depth.distance())
    result = "Orthographic view of the hulls of A and B; the arrow is the shortest way of A that makes them touch.";
  if (s.claimed) result += s.cut ? " The claimed translation is far longer than drawn." : " The claimed translation is drawn dashed.";
  return result;
}

}  // namespace

std::string pair_picture(const Pair& pair, const std::optional<Point>& claimed, const std::string& name, const std::string& label) {
  const Subject subject = subject_of(pair, claimed);
  Panel whole{subject, pair.b.front(), subject.extent};
  std::vector<Dot> shown = whole.dots(pair.a);
  for (const Dot& d : whole.dots(pair.b)) shown.push_back(d);
  for (const Dot& d : whole.dots(pair.a)) {  // the outline of A where it ends up
    const Dot by = whole.dot(sum(whole.centre, subject.moved));
    shown.push_back({d.x + by.x, d.y + by.y});
  }
  for (const Point& end : {subject.moved, subject.claimed.value_or(Point{})}) shown.push_back(whole.dot(sum(subject.anchor, end)));
  whole.frame = Viewport::around(shown);
  std::string result = panel_svg(whole, name + "w", label, description_of(subject));

  const mpq_class longest = std::max(size(subject.moved), subject.claimed ? size(*subject.claimed) : mpq_class(0));
  constexpr double short_arrow = 60, close_scale = 70;  // pixels
  if (longest == 0 || mpq_class(longest / subject.extent).get_d() * whole.frame.scale() >= short_arrow) return result;
  Panel close{subject, subject.anchor, longest};
  close.frame = Viewport({0, 0}, close_scale);
  return result + panel_svg(close, name + "c", label + ", close to the translations", description_of(subject));
}

}  // namespace fathom::picture
