// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "view/atlas/limits.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::atlas {
namespace {

using stages::Index;
using stages::Stages;

constexpr double side = 400, left = 58, top = 36, degree = std::numbers::pi / 180, pole = 1e-7;
constexpr int tick = 30;  // degrees

/// The square of one hemisphere.
struct Square {
  const stages::StagedChart& chart;
  Place right = cross(chart.v, chart.z);

  [[nodiscard]] static Pixel pixel(double longitude, double latitude) {
    const double most = 90 * degree;
    return {left + (std::clamp(longitude, -most, most) / (2 * most) + 0.5) * side, top + (0.5 - latitude / (2 * most)) * side};
  }
  [[nodiscard]] Pixel pixel(const Place& p) const {
    const double along = dot(p, right), ahead = dot(p, chart.z);
    return pixel(std::atan2(along, std::max(ahead, 0.0)), std::atan2(dot(p, chart.v), std::hypot(along, ahead)));
  }
  [[nodiscard]] bool is_pole(const Place& p) const { return std::hypot(dot(p, right), dot(p, chart.z)) < pole; }

  /// The part of an arc in this hemisphere, or a dot where there is only a point of it; "" if there is none to be seen.
  [[nodiscard]] std::string path(const stages::StagedBody& body, Index edge) const {
    const std::optional<SphereArc> arc = arc_of(body, edge);
    std::string result;
    if (!arc) return result;
    for (SphereArc part : parts_in(*arc, chart.z)) {
      if (is_pole(part.at(part.begin))) part.begin += 2 * pole;  // there all longitudes meet: the arc's own is that of its inside
      if (is_pole(part.at(part.end))) part.end -= 2 * pole;
      if (part.begin < part.end) result += path_text(polyline(part, [this](const Place& p) { return pixel(p); }));
    }
    if (result.empty()) {  // as given, it only touches the equator, from outside: a dot
      const Place first = arc->at(arc->begin), last = arc->at(arc->end);
      const Pixel touch = pixel(dot(first, chart.z) > dot(last, chart.z) ? first : last);
      result = path_text({{touch.x - 1, touch.y}, {touch.x + 1, touch.y}});
    }
    return result;
  }
};

std::string axes(const stages::StagedChart& chart) {
  std::string lines, texts;
  for (int at = -90; at <= 90; at += tick) {
    const Pixel p = Square::pixel(at * degree, at * degree);
    if (std::abs(at) < 90)
      lines += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {4:.1f}H{5:.1f}\"/>\n", p.x, top, top + side, left,
                           p.y, left + side);
    texts += fmt::format("<text class=\"soft middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}°</text>\n", p.x, top + side + 16, at);
    texts += fmt::format("<text class=\"soft end\" x=\"{:.1f}\" y=\"{:.1f}\">{}°</text>\n", left - 5, p.y + 4, at);
  }
  texts += fmt::format("<text class=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">longitude</text>\n", left + side / 2, top + side + 34);
  texts +=
      fmt::format("<text class=\"middle\" transform=\"translate({:.1f} {:.1f}) rotate(-90)\">latitude</text>\n", left - 42, top + side / 2);
  texts +=
      fmt::format("<text class=\"head\" x=\"{:.1f}\" y=\"{:.1f}\">{} hemisphere</text>\n", left, top - 12, chart.upper ? "Upper" : "Lower");
  return lines + texts;
}

/// Where the strip of a pair ends: at walls, or at the sides of the square.
double end_of_strip(const Stages& all, const Square& square, const std::optional<Index>& wall, double none) {
  if (!wall) return none;
  const stages::StagedWall& found = square.chart.walls[*wall];
  return square.pixel((found.of_a ? all.a : all.b).nodes[found.node]).x;
}

std::string strip_element(const Stages& all, const Square& square, const stages::StagedPair& pair) {
  const double from = end_of_strip(all, square, pair.strip[0], left), to = end_of_strip(all, square, pair.strip[1], left + side);
  return fmt::format("<rect class=\"strip\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", std::min(from, to), top,
                     std::max(0.5, std::abs(to - from)), side);
}

std::string wall_elements(const Square& square) {
  std::string d;
  for (const stages::StagedDiagram* diagram : {&square.chart.a, &square.chart.b})
    for (const stages::StagedNode& node : diagram->nodes)
      d += fmt::format("M{:.1f} {:.1f}V{:.1f}", Square::pixel(node.longitude, 0).x, top, top + side);
  return d.empty() ? d : fmt::format("<path class=\"wall\" d=\"{}\"/>\n", d);
}

/// All arcs of a body but the lit ones, then those, each as an element of its own.
std::string arc_elements(const Square& square, const stages::StagedDiagram& diagram, const stages::StagedBody& body,
                         const std::set<Index>& lit, const char* style, bool all) {
  std::string quiet, loud;
  for (const stages::StagedArc& arc : diagram.arcs) {
    const bool is_lit = lit.contains(arc.edge);
    if (!is_lit && !all) continue;
    const std::string d = square.path(body, arc.edge);
    if (d.empty()) continue;
    if (is_lit) loud += fmt::format("<path class=\"{} lit\" d=\"{}\"/>\n", style, d);
    else quiet += d;
  }
  return (quiet.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>\n", style, quiet)) + loud;
}

std::string node_elements(const Square& square) {
  std::string result;
  for (const stages::StagedNode& node : square.chart.a.nodes) {
    const Pixel p = Square::pixel(node.longitude, node.latitude);
    result += fmt::format("<circle class=\"node of-a\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\"/>", p.x, p.y);
  }
  for (const stages::StagedNode& node : square.chart.b.nodes) {
    const Pixel p = Square::pixel(node.longitude, node.latitude);
    result += fmt::format("<rect class=\"node of-b\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"4\" height=\"4\"/>", p.x - 2, p.y - 2);
  }
  return result.empty() ? result : result + "\n";
}

std::string optimum_elements(const Stages& all, const Square& square) {
  std::string result;
  const std::size_t shown = std::min(all.contact.optima.size(), most_optima);
  for (std::size_t i = shown; i-- > 0;) {  // the first one on top
    const Place& n = all.contact.optima[i].direction;
    if (dot(n, square.chart.z) < 0) continue;
    const Pixel p = square.pixel(n);
    result += fmt::format("<circle class=\"optimum\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\"/>\n", p.x, p.y, i == 0 ? 7 : 4.5);
  }
  return result;
}

std::string caption_of(const Stages& all, const stages::StagedChart& chart, const std::optional<Index>& lit) {
  std::string text = fmt::format("{} hemisphere: {} arcs of -A, {} of B, {} walls.", chart.upper ? "Upper" : "Lower", chart.a.arcs.size(),
                                 chart.b.arcs.size(), chart.walls.size());
  if (!lit) return text + " No arcs cross.";
  const stages::StagedPair& pair = all.pairs[*lit];
  const bool winner = all.winner && all.winner->pair == *lit;
  return text + fmt::format(" Lit: canonical pair {}, |A_i| = {}, |B_i| = {}: {} crossing{}{}.", *lit, pair.a.size(), pair.b.size(),
                            pair.crossings(), pair.crossings() == 1 ? "" : "s", winner ? ", one of them the optimum" : "");
}

}  // namespace

std::optional<Index> pair_to_light(const Stages& stages, Index chart) {
  if (stages.winner && stages.winner->pair && stages.pairs[*stages.winner->pair].chart == chart) return stages.winner->pair;
  std::optional<Index> result;
  for (Index i = 0; i < stages.pairs.size(); ++i)
    if (stages.pairs[i].chart == chart && (!result || stages.pairs[i].crossings() > stages.pairs[*result].crossings())) result = i;
  return result;
}

ChartPanel chart_panel(const Stages& all, Index chart, std::optional<Index> lit) {
  const Square square{all.charts[chart]};
  const stages::StagedDiagram &a = square.chart.a, &b = square.chart.b;
  const bool all_arcs = a.arcs.size() + b.arcs.size() <= most_arcs, all_walls = square.chart.walls.size() <= most_walls;
  const bool all_nodes = a.nodes.size() + b.nodes.size() <= most_nodes;
  ChartPanel panel{axes(square.chart), caption_of(all, square.chart, lit), ""};
  if (lit)
    panel.content += fmt::format("<text class=\"soft end\" x=\"{:.1f}\" y=\"{:.1f}\">canonical pair {}: {} × {}</text>\n", left + side,
                                 top - 12, *lit, all.pairs[*lit].a.size(), all.pairs[*lit].b.size());
  if (lit) panel.content += strip_element(all, square, all.pairs[*lit]);
  if (all_walls) panel.content += wall_elements(square);
  std::set<Index> lit_a, lit_b;
  if (lit) lit_a = {all.pairs[*lit].a.begin(), all.pairs[*lit].a.end()}, lit_b = {all.pairs[*lit].b.begin(), all.pairs[*lit].b.end()};
  panel.content +=
      arc_elements(square, a, all.a, lit_a, "arc of-a", all_arcs) + arc_elements(square, b, all.b, lit_b, "arc of-b", all_arcs);
  if (all_nodes) panel.content += node_elements(square);
  panel.content += optimum_elements(all, square);
  panel.content += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, top, side, side);
  if (!all_arcs) panel.left_out += fmt::format(" More than {} arcs: only lit ones are drawn.", most_arcs);
  if (!all_walls) panel.left_out += fmt::format(" More than {} walls: they are not drawn.", most_walls);
  return panel;
}

}  // namespace fathom::atlas
