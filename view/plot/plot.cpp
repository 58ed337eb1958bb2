// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/plot/plot.hpp"

#include <fmt/format.h>

#include <cmath>

#include "view/plot/look.hpp"
#include "view/plot/panel.hpp"

namespace fathom::plot {
namespace {

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
  const std::string id = markup(figure.prefix), title = markup(figure.title);
  return fmt::format(
      "<svg {7}class=\"plot\" viewBox=\"0 0 {0} {1:.0f}\" width=\"{0}\" height=\"{1:.0f}\" role=\"img\" aria-labelledby=\"{2}-t {2}-d\">"
      "<title id=\"{2}-t\">{3}</title><desc id=\"{2}-d\">{4}</desc>\n{5}<rect class=\"ground\" width=\"{0}\" height=\"{1:.0f}\"/>\n"
      "<text class=\"title\" x=\"{8}\" y=\"22\">{3}</text>\n{6}</svg>\n",
      panel_width, std::ceil(picture.height), id, title, markup(figure.description), style, picture.content, attributes, panel_margin);
}

}  // namespace

std::string figure_element(const Figure& figure) { return svg(figure, "", ""); }

std::string figure_file(const Figure& figure) {
  return svg(figure, "xmlns=\"http://www.w3.org/2000/svg\" ", fmt::format("<style>\n{}{}</style>\n", colours(), plot_style()));
}

std::string_view plot_style() {
  return R"(svg.plot { --look-0: var(--a); --look-1: var(--b); --look-2: var(--true); --look-3: var(--claimed); --look-4: #6639ba; --look-5: var(--ink);
  max-width: 100%; height: auto; font-family: system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
@media (prefers-color-scheme: dark) { svg.plot { --look-4: #d2a8ff; } }
@media print { svg.plot { --look-4: #6639ba; } }
svg.plot .ground { fill: var(--ground); } svg.plot text { fill: var(--ink); font-size: 13px; } svg.plot text.title { font-size: 16px; font-weight: 600; }
svg.plot text.soft { fill: var(--soft); font-size: 12px; } svg.plot text.panel { font-weight: 600; }
svg.plot .grid { stroke: var(--line); stroke-width: 1; } svg.plot .grid.small { stroke-opacity: .45; } svg.plot .frame { fill: none; stroke: var(--soft); }
svg.plot .zero { stroke: var(--ink); stroke-width: 1.2; } svg.plot .look-0 { --own: var(--look-0); } svg.plot .look-1 { --own: var(--look-1); }
svg.plot .look-2 { --own: var(--look-2); } svg.plot .look-3 { --own: var(--look-3); } svg.plot .look-4 { --own: var(--look-4); }
svg.plot .look-5 { --own: var(--look-5); } svg.plot path { fill: none; stroke: var(--own); stroke-width: 2; stroke-linejoin: round; }
svg.plot path.mark { stroke-width: 1.6; } svg.plot path.full { fill: var(--own); } svg.plot path.hollow { fill: var(--ground); }
svg.plot path.band { fill: var(--own); fill-opacity: .18; stroke: none; }
svg.plot .dash-1 { stroke-dasharray: 8 4; } svg.plot .dash-2 { stroke-dasharray: 2 3; } svg.plot .dash-3 { stroke-dasharray: 10 3 2 3; }
svg.plot .dash-4 { stroke-dasharray: 14 5; } svg.plot .dash-5 { stroke-dasharray: 5 2; }
)";
}

std::optional<double> growth_exponent(std::span<const Place> places) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Place& place : places) {
    if (!(place.x > 0) || !(place.y > 0) || !std::isfinite(place.x) || !std::isfinite(place.y)) continue;
    const double u = std::log(place.x), v = std::log(place.y);
    n += 1, x += u, y += v, xx += u * u, xy += u * v;
  }
  const double spread = n * xx - x * x;
  if (n < 2 || !(spread > 1e-9 * n * xx)) return std::nullopt;
  return (n * xy - x * y) / spread;
}

}  // namespace fathom::plot
