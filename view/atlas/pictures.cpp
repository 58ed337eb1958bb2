// SPDX-License-Identifier: GPL-3.0-or-later
// The part of atlas.hpp that puts panels together.
#include <fmt/format.h>

#include <stdexcept>

#include "view/atlas/sphere_panel.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/style.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::atlas {
namespace {

using stages::Index;
using stages::Stages;

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

/// What the lines mean; of the sphere there are no walls and no strip.
std::string legend(double x, double y, bool of_chart) {
  std::string result = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", x, y);
  std::size_t n = 0;
  result +=
      legend_entry(n++, "<path class=\"arc of-a\" d=\"M0 0H28\"/><circle class=\"node of-a\" cx=\"14\" cy=\"0\" r=\"2.2\"/>", "arcs of -A");
  result += legend_entry(n++, "<path class=\"arc of-a lit\" d=\"M0 0H28\"/>", "A_i of the pair");
  result += legend_entry(n++, "<circle class=\"optimum\" cx=\"14\" cy=\"0\" r=\"6\"/>", "optimum");
  result += legend_entry(
      n++, "<path class=\"arc of-b\" d=\"M0 0H28\"/><rect class=\"node of-b\" x=\"12\" y=\"-2\" width=\"4\" height=\"4\"/>", "arcs of B");
  result += legend_entry(n++, "<path class=\"arc of-b lit\" d=\"M0 0H28\"/>", "B_i of the pair");
  if (of_chart)
    result += legend_entry(
        n++, "<rect class=\"strip\" x=\"4\" y=\"-7\" width=\"20\" height=\"14\"/><path class=\"wall\" d=\"M4 -7V7M24 -7V7M14 -7V7\"/>",
        "its strip, walls");
  return result + "</g>\n";
}

struct Sheet {
  double width, height;
  std::string title, description, content;
};

std::string svg(const Sheet& sheet, const std::string& prefix, bool alone) {
  const std::string id = picture::markup(prefix);
  const std::string style = alone ? fmt::format("<style>\n{}{}</style>\n", picture::colour_style(), picture::coloured(rules, true)) : "";
  return fmt::format(
      "<svg {0}class=\"atlas\" viewBox=\"0 0 {1:.0f} {2:.0f}\" width=\"{1:.0f}\" height=\"{2:.0f}\" role=\"img\" aria-labelledby=\"{3}-t "
      "{3}-d\"><title id=\"{3}-t\">{4}</title><desc id=\"{3}-d\">{5}</desc>\n{6}<rect class=\"ground\" width=\"{1:.0f}\" "
      "height=\"{2:.0f}\"/>\n{7}</svg>\n",
      alone ? "xmlns=\"http://www.w3.org/2000/svg\" " : "", sheet.width, sheet.height, id, picture::markup(sheet.title),
      picture::markup(sheet.description), style, sheet.content);
}

constexpr std::string_view about_charts =
    "Each hemisphere of the Gaussian diagrams of -A and B as a square of longitude and latitude. Nodes are facets, arcs are edges; where "
    "arcs "
    "cross, the sum P of B and -A has a facet.";

Index chart_of(const Stages& stages, const ChartView& view) {
  if (view.chart) return *view.chart;
  if (view.pair) return stages.pairs[*view.pair].chart;
  if (stages.winner && stages.winner->pair) return stages.pairs[*stages.winner->pair].chart;
  return dot(stages.contact.direction, stages.charts[0].z) >= 0 ? 0 : 1;
}

}  // namespace

std::string chart_picture(const Stages& stages, const std::string& prefix, const ChartView& view) {
  if (stages.charts.empty()) return "";
  const Index chart = chart_of(stages, view);
  const ChartPanel panel = chart_panel(stages, chart, view.pair ? view.pair : pair_to_light(stages, chart));
  const double note_row = panel.left_out.empty() ? 0 : row;
  std::string content = panel.content + legend(margin, panel_height, true);
  if (note_row > 0)
    content += fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\">{}</text>\n", margin, panel_height + legend_height - 14,
                           picture::markup(panel.left_out.substr(1)));
  return svg({panel_width, panel_height + legend_height - 20 + note_row, "Chart of the Gaussian diagrams of -A and B",
              panel.caption + panel.left_out, content},
             prefix, false);
}

std::string charts_file(const Stages& stages) {
  if (stages.charts.empty()) throw std::invalid_argument("there are no charts of these bodies");
  std::string content = legend(margin, panel_height, true), description(about_charts);
  for (Index i = 0; i < stages.charts.size(); ++i) {
    const ChartPanel panel = chart_panel(stages, i, pair_to_light(stages, i));
    content += fmt::format("<g transform=\"translate({:.0f} 0)\">\n{}</g>\n", panel_width * i, panel.content);
    description += " " + panel.caption + panel.left_out;
  }
  const double width = panel_width * static_cast<double>(stages.charts.size());
  return svg({width, panel_height + legend_height - 20, "Charts of the Gaussian diagrams of -A and B", description, content}, "charts",
             true);
}

std::string sphere_picture(const Stages& stages, const std::string& prefix, const ChartView& view) {
  if (stages.charts.empty()) return "";
  const SpherePanel panel = sphere_panel(stages, view.pair ? view.pair : pair_to_light(stages, chart_of(stages, view)));
  return svg({panel_width, sphere_height + legend_height - 20, "The sphere with the Gaussian diagrams of -A and B", panel.caption,
              panel.content + legend(margin, sphere_height, false)},
             prefix, false);
}

std::string atlas_style() { return picture::coloured(rules, false); }

}  // namespace fathom::atlas
