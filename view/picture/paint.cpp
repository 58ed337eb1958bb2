// SPDX-License-Identifier: GPL-3.0-or-later
// Paints pictures from strokes upwards: elements, bodies and ways, panels, then pictures for pages
// and as files.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/picture/markup.hpp"
#include "view/picture/scene.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {
namespace {

// The elements of all pictures. Styles are classes of markup.hpp; places are in pixels.

/// Returns a path; empty if there is nothing to draw.
std::string path_element(const std::string& style, const std::string& d) {
  return d.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>", style, d);
}

/// Returns a circle; empty if its place is not finite.
std::string circle_element(const std::string& style, const Dot& at, double radius) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return "";
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", style, at.x, at.y, radius);
}

/// Returns the corners of a box around dots, of which there must be one.
std::pair<Dot, Dot> box_around(const std::vector<Dot>& dots) {
  Dot low = dots.front(), high = dots.front();
  for (const Dot& d : dots) {
    low = {std::min(low.x, d.x), std::min(low.y, d.y)};
    high = {std::max(high.x, d.x), std::max(high.y, d.y)};
  }
  return {low, high};
}

/// Returns the union of convex areas: toned, or filled with the pattern `hatch`; a dot if it would
/// be too small to be seen.
std::string area_element(const std::vector<std::vector<Dot>>& areas, const std::string& style,
                         const std::string& hatch) {
  constexpr double too_small = 3;
  std::vector<Dot> all;
  std::string d;
  for (const std::vector<Dot>& area : areas) {
    all.insert(all.end(), area.begin(), area.end());
    d += path_data(area, true);  // all have the same orientation, so the fill rule nonzero yields their union
  }
  if (all.empty()) return "";
  const auto [low, high] = box_around(all);
  if (high.x - low.x < too_small && high.y - low.y < too_small)
    return circle_element(style + " dot", {(low.x + high.x) / 2, (low.y + high.y) / 2}, 4);
  return hatch.empty() ? path_element(style + " toned", d)
                       : fmt::format("<path class=\"{} hatched\" fill=\"url(#{})\" d=\"{}\"/>", style, hatch, d);
}

/// Returns a face, given by the points that span it: a dot, a line, or the outline of a facet.
std::string feature_element(const std::vector<Point>& points, const Window& window, const std::string& style,
                            double radius) {
  if (points.size() == 1) return circle_element(style, window.dot(points.front()), radius);
  const std::vector<Dot> dots =
      points.size() == 2 ? window.segment(points.front(), points.back()) : window.hull(points);
  return path_element(style, path_data(dots, dots.size() > 2));
}

/// Returns an arrow; a dot if it would be too short to be seen.
std::string arrow_elements(const Dot& from, const Dot& to, const std::string& style) {
  const double right = to.x - from.x, down = to.y - from.y, length = std::sqrt(right * right + down * down);
  if (!(length >= 2)) return circle_element(style + " dot", from, 3);
  const double head = std::min(11.0, length / 2), x = right / length * head, y = down / length * head;
  return fmt::format(
      "<path class=\"{0} shaft\" d=\"{1}\"/><path class=\"{0} head\" d=\"{2}\"/>", style,
      path_data({from, {to.x - x * 0.7, to.y - y * 0.7}}, false),
      path_data({to, {to.x - x - y * 0.4, to.y - y + x * 0.4}, {to.x - x + y * 0.4, to.y - y - x * 0.4}}, true));
}

constexpr double longest_bar = 110;  // pixels
constexpr double bar_inset = 12;     // pixels from the window

/// Returns a bar for a round length; upright for the axis across the way.
std::string bar_elements(const mpq_class& pixels, const PixelSize& size, bool upright) {
  const RoundLength length = round_length(mpq_class(longest_bar / pixels));
  const double reach = mpq_class(length.value * pixels).get_d(), x = bar_inset, y = size.height - bar_inset;
  if (upright)
    return path_element("bar", path_data({{x - 4, y - 24},
                                          {x + 4, y - 24},
                                          {x, y - 24},
                                          {x, y - 24 - reach},
                                          {x - 4, y - 24 - reach},
                                          {x + 4, y - 24 - reach}},
                                         false)) +
           fmt::format("<text class=\"scale\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x + 8, y - 20 - reach / 2,
                       length.text);
  return path_element(
             "bar", path_data({{x, y - 4}, {x, y + 4}, {x, y}, {x + reach, y}, {x + reach, y - 4}, {x + reach, y + 4}},
                              false)) +
         fmt::format("<text class=\"scale\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", x + reach + 8, y + 4, length.text);
}

/// Returns bars for round lengths: one, or two if the axes are scaled differently.
std::string scale_bars(const Window& window) {
  const std::string along = bar_elements(window.scale().x, window.size(), false);
  return window.apart() ? along + bar_elements(window.scale().y, window.size(), true) : along;
}

/// Returns a text in the lower right corner; empty if there is none.
std::string note_element(const std::string& text, const PixelSize& size) {
  if (text.empty()) return "";
  return fmt::format("<text class=\"note\" text-anchor=\"end\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>",
                     size.width - bar_inset, size.height - bar_inset + 4, text);
}

/// Returns the pattern that B is filled with.
std::string hatch_element(const std::string& id) {
  return fmt::format(
      "<defs><pattern id=\"{}\" patternUnits=\"userSpaceOnUse\" width=\"7\" height=\"7\" "
      "patternTransform=\"rotate(45)\">"
      "<rect class=\"body-b toned\" width=\"7\" height=\"7\"/><path class=\"body-b stripe\" d=\"M3.5 "
      "0V7\"/></pattern></defs>",
      id);
}

/// Returns the background of a picture.
std::string ground_element(const PixelSize& size) {
  return fmt::format("<rect class=\"ground\" width=\"{}\" height=\"{}\"/>", size.width, size.height);
}

// The bodies, then all of a scene.

constexpr double short_way = 60;  // pixels: a shorter way gets a close-up
constexpr double close_way = 70;  // its length in the close-up, at most, in each coordinate

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
    std::vector<Dot> run;  // consecutive segments that are joined; parts far outside are cut
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

/// Returns the outlines of all areas.
std::string outline_data(const std::vector<std::vector<Dot>>& areas) {
  if (areas.size() == 1) return path_data(areas.front(), true);
  std::string result;
  for (const auto& [from, to] : united_outline(areas)) result += path_data({from, to}, false);
  return result;
}

/// Returns a union: its area, darker for pieces in contact; thin seams, which are the edges of
/// pieces; the outline.
std::string union_elements(const Compound& body, const Window& window, const std::string& style,
                           const std::string& hatch) {
  const std::vector<std::vector<Dot>> areas = silhouettes(body, window);
  std::vector<std::vector<Dot>> in_contact;
  std::string hidden, seen;
  for (std::size_t i = 0; i < body.pieces.size(); ++i) {
    if (i < body.in_contact.size() && body.in_contact[i]) in_contact.push_back(areas[i]);
    const std::vector<Wires::Wire>& wires = body.pieces[i].wires;
    hidden += edges_data(wires, window, true);
    seen += wires.empty() ? path_data(areas[i], true) : edges_data(wires, window, false);
  }
  return area_element(areas, style, hatch) + area_element(in_contact, style + " in-contact", "") +
         path_element(style + " hidden", hidden) + path_element(style + " seam", seen) +
         path_element(style + " wire", outline_data(areas));
}

/// Returns a body's area, then its edges, hidden ones first; for a body without edges its outline
/// and rims.
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
  return area_element(areas, style, hatch) + path_element(style + " hidden", hidden) +
         path_element(style + " wire", seen);
}

/// Returns the outline of A after a way.
std::string ghost_element(const PairScene& scene, const Window& window) {
  return path_element("ghost", outline_data(silhouettes(scene.a, window, scene.way)));
}

/// Returns the faces in contact, and the patches on them.
std::string contact_elements(const PairScene& scene, const Window& window) {
  std::string result;
  const auto add = [&](const std::vector<std::vector<Point>>& faces, const std::string& style) {
    for (const std::vector<Point>& points : faces)
      result += feature_element(points, window, points.size() == 1 ? style + " dot" : style + " feature", 4.5);
  };
  add(scene.touch_b, "body-b");
  add(scene.touch_a, "body-a");
  for (const std::vector<Point>& corners : scene.patches)
    result += feature_element(corners, window, corners.size() == 1 ? "true dot" : "near", 4.5);
  return result;
}

/// Returns the area with the largest bounding box.
std::vector<Dot> largest_area(const std::vector<std::vector<Dot>>& areas) {
  const auto size = [](const std::vector<Dot>& area) {
    if (area.empty()) return 0.0;
    const auto [low, high] = box_around(area);
    return (high.x - low.x) * (high.y - low.y);
  };
  return *std::ranges::max_element(areas, {}, size);
}

/// Returns the place of a body's letter: in the visible part of it, on the side away from the other
/// body.
std::optional<Dot> letter_place(const std::vector<Dot>& around, const Window& window, double towards) {
  const double inset = 14;
  const std::vector<Dot> seen =
      clipped(around, true, {inset, inset}, {window.size().width - inset, window.size().height - inset});
  if (seen.empty()) return std::nullopt;
  const auto [low, high] = box_around(seen);
  const double x = (low.x + high.x) / 2 + (towards > 0 ? 0.25 : -0.25) * (high.x - low.x);
  const std::vector<Dot> here = clipped(seen, true, {x - 1, low.y}, {x + 1, high.y});
  const auto [top, bottom] = box_around(here.empty() ? seen : here);
  constexpr double half_a_letter = 6;
  return Dot{x, (top.y + bottom.y) / 2 + half_a_letter};
}

std::string letters(const PairScene& scene, const Window& window) {
  const double towards =
      scene.status == Status::disjoint ? -1 : 1;  // A moves to the right; for disjoint bodies it comes from the left
  std::string result;
  const auto add = [&](const Drawn& body, double side, const char* style, const char* letter) {
    if (const std::optional<Dot> at = letter_place(largest_area(silhouettes(body, window)), window, side))
      result +=
          fmt::format("<text class=\"{} letter\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", style, at->x, at->y, letter);
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

Bounds2 whole_box(const PairScene& scene) {
  const View& view = scene.view;
  Bounds2 result = Bounds2::of(view.place(scene.anchor));
  for (const Point& end : {scene.way, scene.claimed.value_or(Point{})}) result.add(view.place(scene.anchor + end));
  for (const Drawn* body : {&scene.a, &scene.b})
    if (const std::optional<Bounds2> box = box_of(*body, view)) result.add(*box);
  if (const std::optional<Bounds2> box = box_of(scene.a, view))
    result.add(box->plus(Bounds2::of(view.place(scene.way))));
  return result;
}

mpq_class greater_side(const Bounds2& box) { return std::max(mpq_class(box.width()), mpq_class(box.height())); }

constexpr PixelSize alone{720, 420}, of_two{356, 340};  // in a file: one panel, or each of two
constexpr double gap = 8, head = 34, line = 19, inset = 12;
constexpr std::size_t widest = 92;  // characters of a line of text

/// Returns the text in lines that fit, broken at spaces.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> result;
  std::string rest = text;
  while (rest.size() > widest) {
    std::size_t at = rest.rfind(' ', widest);
    if (at == std::string::npos || at == 0) at = widest;
    result.push_back(rest.substr(0, at));
    rest = rest.substr(rest[at] == ' ' ? at + 1 : at);
  }
  result.push_back(rest);
  return result;
}

std::string panel_element(const PairScene& scene, const Panel& panel, const Dot& at, const std::string& name) {
  const PixelSize& size = panel.window.size();
  return fmt::format(
      "<svg x=\"{0}\" y=\"{1}\" class=\"pair\" viewBox=\"0 0 {2} {3}\" width=\"{2}\" height=\"{3}\">{4}</svg>\n", at.x,
      at.y, size.width, size.height, painted(scene, panel, name));
}

std::string text_element(const std::string& style, double y, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", style, inset, y, markup(text));
}

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
  const Spot centre{mpq_class(start.x + (ways.low.x + ways.high.x) / 2),
                    mpq_class(start.y + (ways.low.y + ways.high.y) / 2)};
  result.push_back({Window::close(scene.view, centre, mpq_class(close_way / longest), size), true});
  return result;
}

std::string painted(const PairScene& scene, const Panel& panel, const std::string& name) {
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
  return result + notes(scene, panel);
}

std::string description_of(const PairScene& scene) {
  std::string result =
      "Orthographic view of A, toned, and B, hatched, across a shortest way of A out of B, which points to the right.";
  if (!scene.moves())
    result = fmt::format("Orthographic view of A, toned, and B, hatched, along a plane between them; the dot is {}.",
                         scene.dot_text());
  else if (scene.status == Status::disjoint)
    result = "Orthographic view of A, toned, and B, hatched; the arrow is the shortest way of A that makes them touch.";
  if (scene.plane)
    result = fmt::format("A, toned, and B, hatched, in the plane: x to the right, y up; {}.",
                         !scene.moves()                     ? fmt::format("the dot is {}", scene.dot_text())
                         : scene.status == Status::disjoint ? "the arrow is the shortest way of A that makes them touch"
                                                            : "the arrow is a shortest way of A out of B");
  if (scene.moves()) result += " The outline of A moved by it is dashed.";
  if (scene.of_unions()) result += " Both are unions of convex pieces; the deeper ones are those in contact.";
  if (!scene.patches.empty()) result += " The contact patches are drawn on both bodies.";
  if (scene.enclosed) result += " The way is known to within its bounds.";
  if (scene.claimed)
    result += scene.cut ? " The claimed translation is far longer than drawn." : " The claimed translation is dashed.";
  return result;
}

std::string scene_panels(const PairScene& scene, const std::string& name, const std::string& label) {
  std::string result;
  for (const Panel& panel : panels_of(scene, on_pages)) {
    const std::string own = name + (panel.close ? "c" : "w");
    const std::string title = panel.close ? label + ", close to the translations" : label;
    result += svg_element({"pair", on_pages.width, on_pages.height, own, title, description_of(scene)},
                          painted(scene, panel, own));
  }
  return result;
}

std::string scene_document(const PairScene& scene, const std::string& title, std::span<const std::string> caption) {
  std::vector<Panel> panels = panels_of(scene, alone);
  if (panels.size() > 1) panels = panels_of(scene, of_two);
  std::string body, spoken = description_of(scene);
  const std::string name = without_folders(title);
  for (const Panel& panel : panels)
    body += panel_element(scene, panel, {panel.close ? of_two.width + gap : 0, head}, panel.close ? "close" : "whole");
  double y = head + panels.front().window.size().height + line;
  for (const std::string& text : caption) {
    for (const std::string& part : lines_of(text)) {
      body += text_element(&text == caption.data() ? "answer" : "caption", y, part);
      y += line;
    }
    spoken += " " + text + (text.ends_with('.') ? "" : ".");
  }
  const std::string ground = fmt::format("<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", alone.width, y);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
         svg_element({"pair document", alone.width, y, "picture", markup(name), markup(spoken), true},
                     "\n<style>" + document_style() + "</style>\n" + ground +
                         text_element("heading", head - 12, lines_of(name).front()) + body);
}

}  // namespace fathom::picture
