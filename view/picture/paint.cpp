// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/paint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/picture/polygon.hpp"
#include "view/picture/scale_bar.hpp"

namespace fathom::picture {
namespace {

constexpr double short_way = 60;     // pixels: a shorter way gets a close-up
constexpr double close_way = 70;     // how long it is there, in each coordinate at most
constexpr double longest_bar = 110;  // pixels
constexpr double bar_inset = 12;     // pixels from the window

std::string path_element(const std::string& style, const std::string& d) {
  return d.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>", style, d);
}

std::string circle_element(const std::string& style, const Dot& at, double radius, const std::string& more = "") {
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return "";
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"{}/>", style, at.x, at.y, radius, more);
}

/// The corners of a box around dots, of which there is at least one.
std::pair<Dot, Dot> box_around(const std::vector<Dot>& dots) {
  Dot low = dots.front(), high = dots.front();
  for (const Dot& d : dots) {
    low = {std::min(low.x, d.x), std::min(low.y, d.y)};
    high = {std::max(high.x, d.x), std::max(high.y, d.y)};
  }
  return {low, high};
}

/// The area of a body: A's is toned, B's hatched; a dot for what would be too small to be seen.
std::string area_element(const std::vector<Dot>& around, const std::string& style, const std::string& hatch) {
  constexpr double too_small = 3;
  if (around.empty()) return "";
  const auto [low, high] = box_around(around);
  if (high.x - low.x < too_small && high.y - low.y < too_small)
    return circle_element(style + " dot", {(low.x + high.x) / 2, (low.y + high.y) / 2}, 4);
  const std::string d = path_data(around, true);
  return hatch.empty() ? path_element(style + " toned", d)
                       : fmt::format("<path class=\"{} hatched\" fill=\"url(#{})\" d=\"{}\"/>", style, hatch, d);
}

/// A body's area, then its edges: hidden ones first. Of a body without edges its outline.
std::string body_elements(const Drawn& body, const Window& window, const std::string& style, const std::string& hatch) {
  const std::vector<Dot> around = silhouette(body, window);
  std::string hidden, seen;
  const auto* wires = std::get_if<Wires>(&body);
  if (wires)
    for (const Wires::Wire& wire : wires->wires) (wire.hidden ? hidden : seen) += path_data(window.segment(wire.from, wire.to), false);
  if (!wires || wires->wires.empty()) seen = path_data(around, true);
  return area_element(around, style, hatch) + path_element(style + " hidden", hidden) + path_element(style + " wire", seen);
}

/// The outline of A after a way.
std::string ghost_element(const PairScene& scene, const Window& window) {
  return path_element("ghost", path_data(silhouette(scene.a, window, scene.way), true));
}

/// A face: a dot, a line, or the outline of a facet.
std::string feature_element(const std::vector<Point>& points, const Window& window, const std::string& style, double radius,
                            const std::string& more = "") {
  if (points.size() == 1) return circle_element(style, window.dot(points.front()), radius, more);
  const std::vector<Dot> dots = points.size() == 2 ? window.segment(points.front(), points.back()) : window.hull(points);
  const std::string d = path_data(dots, dots.size() > 2);
  return d.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"{}/>", style, d, more);
}

/// The faces in contact. One point is none: the arrow begins or ends there.
std::string contact_elements(const PairScene& scene, const Window& window) {
  std::string result;
  const auto add = [&](const std::vector<Point>& points, const std::string& style) {
    const std::string shown = points.size() == 1 ? style + " dot" : style + " feature";
    result += feature_element(points, window, shown, 4.5);
  };
  add(scene.touch_b, "body-b");
  add(scene.touch_a, "body-a");
  return result;
}

/// An arrow; a dot if it is too short to see.
std::string arrow_elements(const Dot& from, const Dot& to, const std::string& style) {
  const double right = to.x - from.x, down = to.y - from.y, length = std::sqrt(right * right + down * down);
  if (!(length >= 2)) return circle_element(style + " dot", from, 3);
  const double head = std::min(11.0, length / 2), x = right / length * head, y = down / length * head;
  return fmt::format("<path class=\"{0} shaft\" d=\"{1}\"/><path class=\"{0} head\" d=\"{2}\"/>", style,
                     path_data({from, {to.x - x * 0.7, to.y - y * 0.7}}, false),
                     path_data({to, {to.x - x - y * 0.4, to.y - y + x * 0.4}, {to.x - x + y * 0.4, to.y - y - x * 0.4}}, true));
}

/// Where a body's letter stands: in what is seen of it, on the side away from the other body.
std::optional<Dot> letter_place(const std::vector<Dot>& around, const Window& window, double towards) {
  const double inset = 14;
  const std::vector<Dot> seen = clipped(around, true, {inset, inset}, {window.size().width - inset, window.size().height - inset});
  if (seen.empty()) return std::nullopt;
  const auto [low, high] = box_around(seen);
  const double x = (low.x + high.x) / 2 + (towards > 0 ? 0.25 : -0.25) * (high.x - low.x);
  const std::vector<Dot> here = clipped(seen, true, {x - 1, low.y}, {x + 1, high.y});
  const auto [top, bottom] = box_around(here.empty() ? seen : here);
  constexpr double half_a_letter = 6;
  return Dot{x, (top.y + bottom.y) / 2 + half_a_letter};
}

std::string letters(const PairScene& scene, const Window& window) {
  const double towards = scene.status == Status::disjoint ? -1 : 1;  // A moves to the right; if it is apart, it comes from the left
  std::string result;
  const auto add = [&](const Drawn& body, double side, const char* style, const char* letter) {
    if (const std::optional<Dot> at = letter_place(silhouette(body, window), window, side))
      result += fmt::format("<text class=\"{} letter\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", style, at->x, at->y, letter);
  };
  add(scene.b, -towards, "body-b", "B");
  add(scene.a, towards, "body-a", "A");
  return result;
}

/// A bar that stands for a round length; upright for the axis across the way.
std::string bar_elements(const mpq_class& pixels, const PixelSize& size, bool upright) {
  const RoundLength length = round_length(mpq_class(longest_bar / pixels));
  const double reach = mpq_class(length.value * pixels).get_d(), x = bar_inset, y = size.height - bar_inset;
  if (upright)
    return path_element(
               "bar",
               path_data(
                   {{x - 4, y - 24}, {x + 4, y - 24}, {x, y - 24}, {x, y - 24 - reach}, {x - 4, y - 24 - reach}, {x + 4, y - 24 - reach}},
                   false)) +
           fmt::format("<text class=\"scale\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x + 8, y - 20 - reach / 2, length.text);
  return path_element("bar", path_data({{x, y - 4}, {x, y + 4}, {x, y}, {x + reach, y}, {x + reach, y - 4}, {x + reach, y + 4}}, false)) +
         fmt::format("<text class=\"scale\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x + reach + 8, y + 4, length.text);
}

std::string notes(const PairScene& scene, const Panel& panel) {
  std::string text;
  const auto add = [&](bool holds, const char* what) {
    if (holds) text += (text.empty() ? "" : "; ") + std::string(what);
  };
  add(panel.close, "close-up");
  add(panel.window.apart(), "axes scaled apart");
  add(scene.approximate(), "approximate outlines");
  if (text.empty()) return "";
  const PixelSize& size = panel.window.size();
  return fmt::format("<text class=\"note\" text-anchor=\"end\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>", size.width - bar_inset,
                     size.height - bar_inset + 4, text);
}

/// What B is filled with.
std::string hatch_element(const std::string& id) {
  return fmt::format(
      "<defs><pattern id=\"{}\" patternUnits=\"userSpaceOnUse\" width=\"7\" height=\"7\" patternTransform=\"rotate(45)\">"
      "<rect class=\"body-b toned\" width=\"7\" height=\"7\"/><path class=\"body-b stripe\" d=\"M3.5 0V7\"/></pattern></defs>",
      id);
}

std::string mark_elements(const std::vector<Mark>& marks, const Window& window) {
  std::string result;
  for (const Mark& mark : marks)
    result += feature_element(mark.points, window, mark.of_a ? "body-a mark" : "body-b mark", 6, fmt::format(" id=\"{}\"", mark.id));
  return result;
}

Bounds2 whole_box(const PairScene& scene) {
  const View& view = scene.view;
  Bounds2 result = Bounds2::of(view.place(scene.anchor));
  for (const Point& end : {scene.way, scene.claimed.value_or(Point{})}) result.add(view.place(sum(scene.anchor, end)));
  for (const Drawn* body : {&scene.a, &scene.b})
    if (const std::optional<Bounds2> box = box_of(*body, view)) result.add(*box);
  if (const std::optional<Bounds2> box = box_of(scene.a, view)) result.add(box->plus(Bounds2::of(view.place(scene.way))));
  return result;
}

mpq_class greater_side(const Bounds2& box) { return std::max(mpq_class(box.width()), mpq_class(box.height())); }

}  // namespace

std::vector<Panel> panels_of(const PairScene& scene, const PixelSize& size) {
  const Bounds2 box = whole_box(scene);
  std::vector<Panel> result{{Window::around(scene.view, box, size)}};
  Bounds2 ways = Bounds2::of({0, 0});
  ways.add(scene.view.place(scene.way));
  if (scene.claimed) ways.add(scene.view.place(*scene.claimed));
  const mpq_class longest = greater_side(ways), extent = greater_side(box);
  const Spot& scale = result.front().window.scale();
  if (longest == 0 || longest * std::max(scale.x, scale.y) >= short_way) return result;
  if (scene.approximate() && extent > 1'000'000'000 * longest) return result;
  const Spot start = scene.view.place(scene.anchor);
  const Spot centre{mpq_class(start.x + (ways.low.x + ways.high.x) / 2), mpq_class(start.y + (ways.low.y + ways.high.y) / 2)};
  result.push_back({Window::close(scene.view, centre, mpq_class(close_way / longest), size), true});
  return result;
}

std::string painted(const PairScene& scene, const Panel& panel, const std::string& name, const std::vector<Mark>& marks) {
  const Window& window = panel.window;
  const std::string hatch = name + "-h";
  std::string result =
      hatch_element(hatch) + fmt::format("<rect class=\"ground\" width=\"{}\" height=\"{}\"/>", window.size().width, window.size().height);
  result += body_elements(scene.b, window, "body-b", hatch) + body_elements(scene.a, window, "body-a", "");
  if (scene.moves()) result += ghost_element(scene, window);
  result += contact_elements(scene, window);
  const auto arrow = [&](const Point& by, const char* style) {
    return arrow_elements(window.dot(scene.anchor), window.dot(sum(scene.anchor, by)), style);
  };
  result += scene.moves() ? arrow(scene.way, "true") : circle_element("true dot", window.dot(scene.anchor), 3.5);
  if (scene.claimed) result += arrow(*scene.claimed, "claimed");
  result += letters(scene, window) + bar_elements(window.scale().x, window.size(), false);
  if (window.apart()) result += bar_elements(window.scale().y, window.size(), true);
  return result + notes(scene, panel) + (panel.close ? "" : mark_elements(marks, window));
}

}  // namespace fathom::picture
