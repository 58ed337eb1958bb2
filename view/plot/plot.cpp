// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/plot/plot.hpp"

#include <fmt/format.h>

#include <cmath>

#include "view/picture/markup.hpp"
#include "view/picture/style.hpp"
#include "view/plot/panel.hpp"

namespace fathom::plot {
namespace {

/// "@name" stands for a colour of that name.
constexpr std::string_view rules = R"(
svg.plot{max-width:100%;height:auto}
svg.plot .ground{fill:@ground}
svg.plot text{fill:@ink;font-family:system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif;font-size:13px}
svg.plot .title{font-size:16px;font-weight:600}
svg.plot .panel{font-weight:600}
svg.plot .soft{fill:@soft;font-size:12px}
svg.plot .grid{stroke:@line}
svg.plot .small{stroke-opacity:.45}
svg.plot .frame{fill:none;stroke:@soft}
svg.plot .zero{stroke:@ink;stroke-width:1.2}
svg.plot path{fill:none;stroke-width:2;stroke-linejoin:round}
svg.plot .mark{stroke-width:1.6}
svg.plot .hollow{fill:@ground}
svg.plot .look-0{stroke:@a}
svg.plot .look-1{stroke:@b}
svg.plot .look-2{stroke:@true}
svg.plot .look-3{stroke:@claimed}
svg.plot .look-4{stroke:@lit}
svg.plot .look-5{stroke:@ink}
svg.plot .full.look-0{fill:@a}
svg.plot .full.look-1{fill:@b}
svg.plot .full.look-2{fill:@true}
svg.plot .full.look-3{fill:@claimed}
svg.plot .full.look-4{fill:@lit}
svg.plot .full.look-5{fill:@ink}
svg.plot .band{fill:@a;fill-opacity:.18;stroke:none}
svg.plot .dash-1{stroke-dasharray:8 4}
svg.plot .dash-2{stroke-dasharray:2 3}
svg.plot .dash-3{stroke-dasharray:10 3 2 3}
svg.plot .dash-4{stroke-dasharray:14 5}
svg.plot .dash-5{stroke-dasharray:5 2}
)";

constexpr double title_room = 34, panel_gap = 22;

struct Drawn {
  std::string content;
  double height;
};

Drawn drawn(const Figure& figure) {
  std::string content;
  double y = title_room;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const PanelPicture picture = panel_picture(figure.panels[i], fmt::format("{}-clip{}", figure.prefix, i));
    content += fmt::format("<g transform=\"translate(0 {:.1f})\">\n{}</g>\n", y, picture.content);
    y += picture.height + panel_gap;
  }
  return {content, y - panel_gap};
}

std::string svg(const Figure& figure, std::string_view attributes, std::string_view style) {
  const Drawn picture = drawn(figure);
  const std::string id = picture::markup(figure.prefix), title = picture::markup(figure.title);
  return fmt::format(
      "<svg {7}class=\"plot\" viewBox=\"0 0 {0} {1:.0f}\" width=\"{0}\" height=\"{1:.0f}\" role=\"img\" aria-labelledby=\"{2}-t {2}-d\">"
      "<title id=\"{2}-t\">{3}</title><desc id=\"{2}-d\">{4}</desc>\n{5}<rect class=\"ground\" width=\"{0}\" height=\"{1:.0f}\"/>\n"
      "<text class=\"title\" x=\"{8}\" y=\"22\">{9}</text>\n{6}</svg>\n",
      panel_width, std::ceil(picture.height), id, title, picture::markup(figure.description), style, picture.content, attributes,
      panel_margin, fitting(figure.title));
}

}  // namespace

std::string figure_element(const Figure& figure) { return svg(figure, "", ""); }

std::string figure_file(const Figure& figure) {
  return svg(figure, "xmlns=\"http://www.w3.org/2000/svg\" ",
             fmt::format("<style>\n{}{}</style>\n", picture::colour_style(), picture::coloured(rules, true)));
}

std::string plot_style() { return picture::coloured(rules, false); }

std::optional<double> growth_exponent(std::span<const Datum> places) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Datum& place : places) {
    if (!(place.x > 0) || !(place.y > 0) || !std::isfinite(place.x) || !std::isfinite(place.y)) continue;
    const double u = std::log(place.x), v = std::log(place.y);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  const double spread = n * xx - x * x;
  if (n < 2 || !(spread > 1e-9 * n * xx)) return std::nullopt;
  return (n * xy - x * y) / spread;
}

}  // namespace fathom::plot
