// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/strokes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "view/picture/view.hpp"

namespace fathom::picture {
namespace {

constexpr double longest_bar = 110;  // pixels
constexpr double bar_inset = 12;     // pixels from the window

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

}  // namespace

std::string path_element(const std::string& style, const std::string& d) {
  return d.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"/>", style, d);
}

std::string circle_element(const std::string& style, const Dot& at, double radius, const std::string& more) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return "";
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"{}/>", style, at.x, at.y, radius, more);
}

std::pair<Dot, Dot> box_around(const std::vector<Dot>& dots) {
  Dot low = dots.front(), high = dots.front();
  for (const Dot& d : dots) {
    low = {std::min(low.x, d.x), std::min(low.y, d.y)};
    high = {std::max(high.x, d.x), std::max(high.y, d.y)};
  }
  return {low, high};
}

std::string area_element(const std::vector<std::vector<Dot>>& areas, const std::string& style, const std::string& hatch) {
  constexpr double too_small = 3;
  std::vector<Dot> all;
  std::string d;
  for (const std::vector<Dot>& area : areas) {
    all.insert(all.end(), area.begin(), area.end());
    d += path_data(area, true);  // all turn the same way: the fill rule nonzero makes their union
  }
  if (all.empty()) return "";
  const auto [low, high] = box_around(all);
  if (high.x - low.x < too_small && high.y - low.y < too_small)
    return circle_element(style + " dot", {(low.x + high.x) / 2, (low.y + high.y) / 2}, 4);
  return hatch.empty() ? path_element(style + " toned", d)
                       : fmt::format("<path class=\"{} hatched\" fill=\"url(#{})\" d=\"{}\"/>", style, hatch, d);
}

std::string feature_element(const std::vector<Point>& points, const Window& window, const std::string& style, double radius,
                            const std::string& more) {
  if (points.size() == 1) return circle_element(style, window.dot(points.front()), radius, more);
  const std::vector<Dot> dots = points.size() == 2 ? window.segment(points.front(), points.back()) : window.hull(points);
  const std::string d = path_data(dots, dots.size() > 2);
  return d.empty() ? "" : fmt::format("<path class=\"{}\" d=\"{}\"{}/>", style, d, more);
}

std::string arrow_elements(const Dot& from, const Dot& to, const std::string& style) {
  const double right = to.x - from.x, down = to.y - from.y, length = std::sqrt(right * right + down * down);
  if (!(length >= 2)) return circle_element(style + " dot", from, 3);
  const double head = std::min(11.0, length / 2), x = right / length * head, y = down / length * head;
  return fmt::format("<path class=\"{0} shaft\" d=\"{1}\"/><path class=\"{0} head\" d=\"{2}\"/>", style,
                     path_data({from, {to.x - x * 0.7, to.y - y * 0.7}}, false),
                     path_data({to, {to.x - x - y * 0.4, to.y - y + x * 0.4}, {to.x - x + y * 0.4, to.y - y - x * 0.4}}, true));
}

std::string scale_bars(const Window& window) {
  const std::string along = bar_elements(window.scale().x, window.size(), false);
  return window.apart() ? along + bar_elements(window.scale().y, window.size(), true) : along;
}

std::string note_element(const std::string& text, const PixelSize& size) {
  if (text.empty()) return "";
  return fmt::format("<text class=\"note\" text-anchor=\"end\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>", size.width - bar_inset,
                     size.height - bar_inset + 4, text);
}

std::string hatch_element(const std::string& id) {
  return fmt::format(
      "<defs><pattern id=\"{}\" patternUnits=\"userSpaceOnUse\" width=\"7\" height=\"7\" patternTransform=\"rotate(45)\">"
      "<rect class=\"body-b toned\" width=\"7\" height=\"7\"/><path class=\"body-b stripe\" d=\"M3.5 0V7\"/></pattern></defs>",
      id);
}

std::string ground_element(const PixelSize& size) {
  return fmt::format("<rect class=\"ground\" width=\"{}\" height=\"{}\"/>", size.width, size.height);
}

std::string svg_opening(const std::string& more, const PixelSize& size, const std::string& style) {
  return fmt::format("<svg{0} class=\"{1}\" viewBox=\"0 0 {2} {3}\" width=\"{2}\" height=\"{3}\"", more, style, size.width, size.height);
}

std::string svg_told(const std::string& name, const std::string& title, const std::string& description) {
  return fmt::format(" role=\"img\" aria-labelledby=\"{0}-t {0}-d\"><title id=\"{0}-t\">{1}</title><desc id=\"{0}-d\">{2}</desc>", name,
                     title, description);
}

}  // namespace fathom::picture
