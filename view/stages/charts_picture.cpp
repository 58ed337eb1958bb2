// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <stdexcept>

#include "view/picture/markup.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {
namespace {

constexpr std::size_t most_arcs = 6000, most_walls = 400, most_nodes = 250;  ///< that a chart shows

using std::numbers::pi;

constexpr double least_angle = 1e-9;  // radians
constexpr double flatness = 0.2;      // pixels
constexpr unsigned first_splits = 3, most_splits = 12;

Place scaled(const Place& p, double by) { return {p[0] * by, p[1] * by, p[2] * by}; }
double length(const Place& p) { return std::hypot(p[0], p[1], p[2]); }

struct Refiner {
  const SphereArc& arc;
  const Projection& project;
  std::vector<Pixel>& result;

  void add(double begin, const Pixel& first, double end, const Pixel& last, unsigned splits) const {
    const double middle = (begin + end) / 2;
    const Pixel pixel = project(arc.at(middle));
    const double off = std::hypot(pixel.x - (first.x + last.x) / 2, pixel.y - (first.y + last.y) / 2);
    if (splits < most_splits && (splits < first_splits || off > flatness)) {
      add(begin, first, middle, pixel, splits + 1);
      add(middle, pixel, end, last, splits + 1);
    } else if (std::hypot(last.x - result.back().x, last.y - result.back().y) > flatness / 2 || end == arc.end) {
      result.push_back(last);
    }
  }
};

constexpr std::size_t most_charted_optima = 200;  // in a chart
constexpr double side = 400, left = 58, top = 36, degree = std::numbers::pi / 180, pole = 1e-7;
constexpr int tick = 30;  // degrees

/// "M1.0 2.0L3.0 4.0"
std::string path_text(const std::vector<Pixel>& pixels) {
  std::string result;
  for (const Pixel& pixel : pixels)
    result += fmt::format("{}{:.1f} {:.1f}", result.empty() ? 'M' : 'L', pixel.x, pixel.y);
  return result;
}

/// The square of one hemisphere.
struct Square {
  const StagedChart& chart;
  Place right = cross(chart.v, chart.z);

  [[nodiscard]] static Pixel pixel(double longitude, double latitude) {
    const double most = 90 * degree;
    return {left + (std::clamp(longitude, -most, most) / (2 * most) + 0.5) * side,
            top + (0.5 - latitude / (2 * most)) * side};
  }
  [[nodiscard]] Pixel pixel(const Place& p) const {
    const double along = dot(p, right), ahead = dot(p, chart.z);
    return pixel(std::atan2(along, std::max(ahead, 0.0)), std::atan2(dot(p, chart.v), std::hypot(along, ahead)));
  }
  [[nodiscard]] bool is_pole(const Place& p) const { return std::hypot(dot(p, right), dot(p, chart.z)) < pole; }

  /// Returns the path of the part of an arc in this hemisphere, a dot if the part is a point; "" if
  /// there is none.
  [[nodiscard]] std::string path(const StagedBody& body, Index edge) const {
    const std::optional<SphereArc> arc = arc_of(body, edge);
    std::string result;
    if (!arc) return result;
    for (SphereArc part : parts_in(*arc, chart.z)) {
      if (is_pole(part.at(part.begin)))
        part.begin += 2 * pole;  // all longitudes meet there: the arc has that of its inside
      if (is_pole(part.at(part.end))) part.end -= 2 * pole;
      if (part.begin < part.end) result += path_text(polyline(part, [this](const Place& p) { return pixel(p); }));
    }
    if (result.empty()) {  // the arc only touches the equator, from outside
      const Place first = arc->at(arc->begin), last = arc->at(arc->end);
      const Pixel touch = pixel(dot(first, chart.z) > dot(last, chart.z) ? first : last);
      result = path_text({{touch.x - 1, touch.y}, {touch.x + 1, touch.y}});
    }
    return result;
  }
};

std::string axes(const StagedChart& chart) {
  std::string lines, texts;
  for (int at = -90; at <= 90; at += tick) {
    const Pixel p = Square::pixel(at * degree, at * degree);
    if (std::abs(at) < 90)
      lines += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {4:.1f}H{5:.1f}\"/>\n", p.x, top,
                           top + side, left, p.y, left + side);
    texts +=
        fmt::format("<text class=\"soft middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}°</text>\n", p.x, top + side + 16, at);
    texts += fmt::format("<text class=\"soft end\" x=\"{:.1f}\" y=\"{:.1f}\">{}°</text>\n", left - 5, p.y + 4, at);
  }
  texts += fmt::format("<text class=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">longitude</text>\n", left + side / 2,
                       top + side + 34);
  texts += fmt::format("<text class=\"middle\" transform=\"translate({:.1f} {:.1f}) rotate(-90)\">latitude</text>\n",
                       left - 42, top + side / 2);
  texts += fmt::format("<text class=\"head\" x=\"{:.1f}\" y=\"{:.1f}\">{} hemisphere</text>\n", left, top - 12,
                       chart.upper ? "Upper" : "Lower");
  return lines + texts;
}

/// Returns the end of a pair's strip: at a wall, or at a side of the square.
double end_of_strip(const Stages& all, const Square& square, const std::optional<Index>& wall, double none) {
  if (!wall) return none;
  const StagedWall& found = square.chart.walls[*wall];
  return square.pixel((found.of_a ? all.a : all.b).nodes[found.node]).x;
}

std::string strip_element(const Stages& all, const Square& square, const StagedPair& pair) {
  const double from = end_of_strip(all, square, pair.strip[0], left),
               to = end_of_strip(all, square, pair.strip[1], left + side);
  return fmt::format("<rect class=\"strip\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n",
                     std::min(from, to), top, std::max(0.5, std::abs(to - from)), side);
}

std::string wall_elements(const Square& square) {
  std::string d;
  for (const StagedDiagram* diagram : {&square.chart.a, &square.chart.b})
    for (const StagedNode& node : diagram->nodes)
      d += fmt::format("M{:.1f} {:.1f}V{:.1f}", Square::pixel(node.longitude, 0).x, top, top + side);
  return d.empty() ? d : fmt::format("<path class=\"wall\" d=\"{}\"/>\n", d);
}

/// Returns all arcs of a body, the highlighted ones last, each as an element of its own.
std::string arc_elements(const Square& square, const StagedDiagram& diagram, const StagedBody& body,
                         const std::set<Index>& lit, const char* style, bool all) {
  std::string quiet, loud;
  for (const StagedArc& arc : diagram.arcs) {
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
  for (const StagedNode& node : square.chart.a.nodes) {
    const Pixel p = Square::pixel(node.longitude, node.latitude);
    result += fmt::format("<circle class=\"node of-a\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\"/>", p.x, p.y);
  }
  for (const StagedNode& node : square.chart.b.nodes) {
    const Pixel p = Square::pixel(node.longitude, node.latitude);
    result +=
        fmt::format("<rect class=\"node of-b\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"4\" height=\"4\"/>", p.x - 2, p.y - 2);
  }
  return result.empty() ? result : result + "\n";
}

std::string optimum_elements(const Stages& all, const Square& square) {
  std::string result;
  const std::size_t shown = std::min(all.contact.optima.size(), most_charted_optima);
  for (std::size_t i = shown; i-- > 0;) {  // so that the first one is on top
    const Place& n = all.contact.optima[i].direction;
    if (dot(n, square.chart.z) < 0) continue;
    const Pixel p = square.pixel(n);
    result += fmt::format("<circle class=\"optimum\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\"/>\n", p.x, p.y,
                          i == 0 ? 7 : 4.5);
  }
  return result;
}

std::string caption_of(const Stages& all, const StagedChart& chart, const std::optional<Index>& lit) {
  std::string text = fmt::format("{} hemisphere: {} arcs of -A, {} of B, {} walls.", chart.upper ? "Upper" : "Lower",
                                 chart.a.arcs.size(), chart.b.arcs.size(), chart.walls.size());
  if (!lit) return text + " No arcs cross.";
  const StagedPair& pair = all.pairs[*lit];
  const bool winner = all.winner && all.winner->pair == *lit;
  return text + fmt::format(" Lit: canonical pair {}, |A_i| = {}, |B_i| = {}: {} crossing{}{}.", *lit, pair.a.size(),
                            pair.b.size(), pair.crossings(), pair.crossings() == 1 ? "" : "s",
                            winner ? ", one of them the optimum" : "");
}

constexpr double panel_width = 492, panel_height = 500;
constexpr double legend_height = 64, row = 20, column = 158, margin = 58;

/// "@name" stands for a colour of that name.
constexpr std::string_view rules = R"(
svg.atlas{max-width:100%;height:auto}
svg.atlas .ground{fill:@ground}
svg.atlas text{fill:@ink;font-family:system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif;font-size:13px}
svg.atlas .soft{fill:@soft;font-size:12px}
svg.atlas .head{font-weight:600;font-size:14px}
svg.atlas .middle{text-anchor:middle}
svg.atlas .end{text-anchor:end}
svg.atlas .arc,svg.atlas .grid,svg.atlas .wall,svg.atlas .frame,svg.atlas .ball,svg.atlas .optimum{fill:none}
svg.atlas .grid{stroke:@line;stroke-opacity:.5}
svg.atlas .wall{stroke:@soft;stroke-width:.6;stroke-opacity:.5}
svg.atlas .frame,svg.atlas .ball{stroke:@soft}
svg.atlas .strip{fill:@lit;fill-opacity:.14}
svg.atlas .arc{stroke-width:1.1;stroke-linejoin:round}
svg.atlas .arc.of-a{stroke:@a}
svg.atlas .arc.of-b{stroke:@b;stroke-dasharray:5 3}
svg.atlas .arc.far{stroke-opacity:.28}
svg.atlas .arc.lit{stroke-width:2.8}
svg.atlas .node.of-a{fill:@a}
svg.atlas .node.of-b{fill:@b}
svg.atlas .optimum{stroke:@true;stroke-width:2.5}
)";

std::string legend_entry(std::size_t number, std::string_view sample, std::string_view words) {
  return fmt::format("<g transform=\"translate({:.0f} {:.0f})\">{}<text x=\"36\" y=\"4\">{}</text></g>\n",
                     column * static_cast<double>(number % 3), row * static_cast<double>(number / 3), sample, words);
}

/// Returns the legend of the lines.
std::string legend(double x, double y) {
  std::string result = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", x, y);
  std::size_t n = 0;
  result += legend_entry(
      n++, "<path class=\"arc of-a\" d=\"M0 0H28\"/><circle class=\"node of-a\" cx=\"14\" cy=\"0\" r=\"2.2\"/>",
      "arcs of -A");
  result += legend_entry(n++, "<path class=\"arc of-a lit\" d=\"M0 0H28\"/>", "A_i of the pair");
  result += legend_entry(n++, "<circle class=\"optimum\" cx=\"14\" cy=\"0\" r=\"6\"/>", "optimum");
  result += legend_entry(
      n++,
      "<path class=\"arc of-b\" d=\"M0 0H28\"/><rect class=\"node of-b\" x=\"12\" y=\"-2\" width=\"4\" height=\"4\"/>",
      "arcs of B");
  result += legend_entry(n++, "<path class=\"arc of-b lit\" d=\"M0 0H28\"/>", "B_i of the pair");
  result += legend_entry(n++,
                         "<rect class=\"strip\" x=\"4\" y=\"-7\" width=\"20\" height=\"14\"/><path class=\"wall\" "
                         "d=\"M4 -7V7M24 -7V7M14 -7V7\"/>",
                         "its strip, walls");
  return result + "</g>\n";
}

constexpr std::string_view about_charts =
    "Each hemisphere of the Gaussian diagrams of -A and B as a square of longitude and latitude. Nodes are facets, "
    "arcs are edges; where "
    "arcs "
    "cross, the sum P of B and -A has a facet.";

}  // namespace

Place SphereArc::at(double t) const {
  const double c = std::cos(t), s = std::sin(t);
  return {c * from[0] + s * side[0], c * from[1] + s * side[1], c * from[2] + s * side[2]};
}

std::optional<SphereArc> arc_of(const StagedBody& body, stages::Index edge) {
  const auto& [from, to] = body.arcs[edge];
  if (from && to && body.rank == 3) {
    const Place &p = body.nodes[*from], &q = body.nodes[*to];
    const Place circle = cross(p, q);
    const double size = length(circle);
    if (size < least_angle) return std::nullopt;
    return SphereArc{p, cross(scaled(circle, 1 / size), p), 0, std::atan2(size, dot(p, q))};
  }
  if (edge >= body.circles.size()) return std::nullopt;
  const Place& circle = body.circles[edge];
  if (from) return SphereArc{body.nodes[*from], cross(circle, body.nodes[*from]), 0, pi};
  // A full circle may begin at any of its points.
  const Place axis = std::abs(circle[0]) < 0.6 ? Place{1, 0, 0} : Place{0, 1, 0};
  const Place start = cross(circle, axis);
  const Place unit = scaled(start, 1 / length(start));
  return SphereArc{unit, cross(circle, unit), 0, 2 * pi};
}

std::vector<SphereArc> parts_in(const SphereArc& arc, const Place& z) {
  const double a = dot(arc.from, z), b = dot(arc.side, z);
  if (std::hypot(a, b) < least_angle) return {arc};  // the whole arc lies on the equator
  const double top = std::atan2(b, a);
  std::vector<SphereArc> parts;
  for (const int turn : {-1, 0, 1}) {
    SphereArc part = arc;
    part.begin = std::max(arc.begin, top - pi / 2 + 2 * pi * turn);
    part.end = std::min(arc.end, top + pi / 2 + 2 * pi * turn);
    if (part.end - part.begin > least_angle) parts.push_back(part);
  }
  return parts;
}

std::vector<Pixel> polyline(const SphereArc& arc, const Projection& project) {
  std::vector<Pixel> result{project(arc.at(arc.begin))};
  const Pixel last = project(arc.at(arc.end));
  Refiner{arc, project, result}.add(arc.begin, result.front(), arc.end, last, 0);
  return result;
}

std::optional<Index> pair_to_light(const Stages& stages, Index chart) {
  if (stages.winner && stages.winner->pair && stages.pairs[*stages.winner->pair].chart == chart)
    return stages.winner->pair;
  std::optional<Index> result;
  for (Index i = 0; i < stages.pairs.size(); ++i)
    if (stages.pairs[i].chart == chart && (!result || stages.pairs[i].crossings() > stages.pairs[*result].crossings()))
      result = i;
  return result;
}

ChartPanel chart_panel(const Stages& all, Index chart, std::optional<Index> lit) {
  const Square square{all.charts[chart]};
  const StagedDiagram &a = square.chart.a, &b = square.chart.b;
  const bool all_arcs = a.arcs.size() + b.arcs.size() <= most_arcs, all_walls = square.chart.walls.size() <= most_walls;
  const bool all_nodes = a.nodes.size() + b.nodes.size() <= most_nodes;
  ChartPanel panel{axes(square.chart), caption_of(all, square.chart, lit), ""};
  if (lit)
    panel.content +=
        fmt::format("<text class=\"soft end\" x=\"{:.1f}\" y=\"{:.1f}\">canonical pair {}: {} × {}</text>\n",
                    left + side, top - 12, *lit, all.pairs[*lit].a.size(), all.pairs[*lit].b.size());
  if (lit) panel.content += strip_element(all, square, all.pairs[*lit]);
  if (all_walls) panel.content += wall_elements(square);
  std::set<Index> lit_a, lit_b;
  if (lit)
    lit_a = {all.pairs[*lit].a.begin(), all.pairs[*lit].a.end()},
    lit_b = {all.pairs[*lit].b.begin(), all.pairs[*lit].b.end()};
  panel.content += arc_elements(square, a, all.a, lit_a, "arc of-a", all_arcs) +
                   arc_elements(square, b, all.b, lit_b, "arc of-b", all_arcs);
  if (all_nodes) panel.content += node_elements(square);
  panel.content += optimum_elements(all, square);
  panel.content +=
      fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, top, side, side);
  if (!all_arcs) panel.left_out += fmt::format(" More than {} arcs: only lit ones are drawn.", most_arcs);
  if (!all_walls) panel.left_out += fmt::format(" More than {} walls: they are not drawn.", most_walls);
  return panel;
}

std::string charts_file(const Stages& stages) {
  if (stages.charts.empty()) throw std::invalid_argument("there are no charts of these bodies");
  std::string content = legend(margin, panel_height), description(about_charts);
  for (Index i = 0; i < stages.charts.size(); ++i) {
    const ChartPanel panel = chart_panel(stages, i, pair_to_light(stages, i));
    content += fmt::format("<g transform=\"translate({:.0f} 0)\">\n{}</g>\n", panel_width * i, panel.content);
    description += " " + panel.caption + panel.left_out;
  }
  const double width = panel_width * static_cast<double>(stages.charts.size()),
               height = panel_height + legend_height - 20;
  const std::string style =
      fmt::format("\n<style>\n{}{}</style>\n", picture::colour_style(), picture::coloured(rules, true));
  const std::string ground =
      fmt::format("<rect class=\"ground\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", width, height);
  return picture::svg_element({"atlas", width, height, "charts", "Charts of the Gaussian diagrams of -A and B",
                               picture::markup(description), true},
                              style + ground + content);
}

}  // namespace fathom::stages
