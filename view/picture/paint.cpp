// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/paint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/picture/polygon.hpp"
#include "view/picture/strokes.hpp"

namespace fathom::picture {
namespace {

constexpr double short_way = 60;  // pixels: a shorter way gets a close-up
constexpr double close_way = 70;  // how long it is there, in each coordinate at most

std::string edges_data(const std::vector<Wires::Wire>& wires, const Window& window, bool hidden) {
  std::string result;
  for (const Wires::Wire& wire : wires)
    if (wire.hidden == hidden) result += path_data(window.segment(wire.from, wire.to), false);
  return result;
}

std::string rims_data(const std::vector<Rim>& rims, const Window& window, bool hidden) {
  std::string result;
  for (const Rim& rim : rims) {
    if (rim.hidden != hidden) continue;
    std::vector<Dot> run;  // of segments that follow one another; what is far outside is cut
    for (std::size_t i = 1; i < rim.path.size(); ++i) {
      const std::vector<Dot> segment = window.segment(rim.path[i - 1], rim.path[i]);
      if (segment.size() < 2) continue;
      if (!run.empty() && (run.back().x != segment[0].x || run.back().y != segment[0].y))
        result += path_data(std::exchange(run, {}), false);
      if (run.empty()) run.push_back(segment[0]);
      run.push_back(segment[1]);
    }
    result += path_data(run, false);
  }
  return result;
}

/// The outline of all areas together.
std::string outline_data(const std::vector<std::vector<Dot>>& areas) {
  if (areas.size() == 1) return path_data(areas.front(), true);
  std::string result;
  for (const auto& [from, to] : united_outline(areas)) result += path_data({from, to}, false);
  return result;
}

/// A union: its area, deeper where pieces are in contact; thin seams, which are the edges of pieces; the outline.
std::string union_elements(const Compound& body, const Window& window, const std::string& style, const std::string& hatch) {
  const std::vector<std::vector<Dot>> areas = silhouettes(body, window);
  std::vector<std::vector<Dot>> in_contact;
  std::string hidden, seen;
  for (std::size_t i = 0; i < body.pieces.size(); ++i) {
    if (i < body.in_contact.size() && body.in_contact[i]) in_contact.push_back(areas[i]);
    const std::vector<Wires::Wire>& wires = body.pieces[i].wires;
    hidden += edges_data(wires, window, true);
    seen += wires.empty() ? path_data(areas[i], true) : edges_data(wires, window, false);
  }
  return area_element(areas, style, hatch) + area_element(in_contact, style + " in-contact", "") + path_element(style + " hidden", hidden) +
         path_element(style + " seam", seen) + path_element(style + " wire", outline_data(areas));
}

/// A body's area, then its edges: hidden ones first. Of a body without edges its outline, and its rims.
std::string body_elements(const Drawn& body, const Window& window, const std::string& style, const std::string& hatch) {
  if (const auto* compound = std::get_if<Compound>(&body)) return union_elements(*compound, window, style, hatch);
  const std::vector<std::vector<Dot>> areas = silhouettes(body, window);
  std::string hidden, seen;
  const auto* wires = std::get_if<Wires>(&body);
  if (wires && !wires->wires.empty()) {
    hidden = edges_data(wires->wires, window, true);
    seen = edges_data(wires->wires, window, false);
  } else {
    seen = outline_data(areas);
  }
  if (const auto* curved = std::get_if<Curved>(&body)) {
    hidden = rims_data(curved->rims, window, true);
    seen += rims_data(curved->rims, window, false);
  }
  return area_element(areas, style, hatch) + path_element(style + " hidden", hidden) + path_element(style + " wire", seen);
}

/// The outline of A after a way.
std::string ghost_element(const PairScene& scene, const Window& window) {
  return path_element("ghost", outline_data(silhouettes(scene.a, window, scene.way)));
}

/// The faces in contact.
std::string contact_elements(const PairScene& scene, const Window& window) {
  std::string result;
  const auto add = [&](const std::vector<std::vector<Point>>& faces, const std::string& style) {
    for (const std::vector<Point>& points : faces)
      result += feature_element(points, window, points.size() == 1 ? style + " dot" : style + " feature", 4.5);
  };
  add(scene.touch_b, "body-b");
  add(scene.touch_a, "body-a");
  return result;
}

/// Of the areas the one with the greatest box.
std::vector<Dot> largest(const std::vector<std::vector<Dot>>& areas) {
  const auto size = [](const std::vector<Dot>& area) {
    if (area.empty()) return 0.0;
    const auto [low, high] = box_around(area);
    return (high.x - low.x) * (high.y - low.y);
  };
  return *std::ranges::max_element(areas, {}, size);
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
    if (const std::optional<Dot> at = letter_place(largest(silhouettes(body, window)), window, side))
      result += fmt::format("<text class=\"{} letter\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", style, at->x, at->y, letter);
  };
  add(scene.b, -towards, "body-b", "B");
  add(scene.a, towards, "body-a", "A");
  return result;
}

std::string notes(const PairScene& scene, const Panel& panel) {
  std::string text;
  const auto add = [&](bool holds, const char* what) {
    if (holds) text += (text.empty() ? "" : "; ") + std::string(what);
  };
  add(panel.close, "close-up");
  add(panel.window.apart(), "axes scaled apart");
  add(scene.approximate(), "approximate outlines");
  return note_element(text, panel.window.size());
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
  for (const Point& end : {scene.way, scene.claimed.value_or(Point{})}) result.add(view.place(scene.anchor + end));
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
  std::string result = hatch_element(hatch) + ground_element(window.size());
  result += body_elements(scene.b, window, "body-b", hatch) + body_elements(scene.a, window, "body-a", "");
  if (scene.moves()) result += ghost_element(scene, window);
  result += contact_elements(scene, window);
  const auto arrow = [&](const Point& by, const char* style) {
    return arrow_elements(window.dot(scene.anchor), window.dot(scene.anchor + by), style);
  };
  result += scene.moves() ? arrow(scene.way, "true") : circle_element("true dot", window.dot(scene.anchor), 3.5);
  if (scene.claimed) result += arrow(*scene.claimed, "claimed");
  result += letters(scene, window) + scale_bars(window);
  return result + notes(scene, panel) + (panel.close ? "" : mark_elements(marks, window));
}

}  // namespace fathom::picture
