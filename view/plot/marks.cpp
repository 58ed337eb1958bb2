// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/plot/marks.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "view/picture/markup.hpp"
#include "view/plot/plot.hpp"

namespace fathom::plot {
namespace {

/// A marker around the origin.
struct Shape {
  std::string_view path, fill;
};

constexpr std::array<Shape, distinct_looks> shapes{
    Shape{"m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", "full"},    // a disc
    Shape{"m-3.6 -3.6h7.2v7.2h-7.2z", "full"},               // a square
    Shape{"m0 -4.8l4.6 8h-9.2z", "hollow"},                  // a triangle
    Shape{"m0 -5l5 5l-5 5l-5 -5z", "hollow"},                // a diamond
    Shape{"m-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0z", "hollow"},  // a ring
    Shape{"m-4 -4l8 8m0 -8l-8 8", "cross"},
};

}  // namespace

std::string mark_element(std::size_t series, double x, double y, const std::string& what) {
  const std::size_t look = series % distinct_looks;
  const std::string start =
      fmt::format("<path class=\"mark {} look-{}\" d=\"M{:.1f} {:.1f}{}\"", shapes[look].fill, look, x, y, shapes[look].path);
  return what.empty() ? start + "/>" : fmt::format("{}><title>{}</title></path>", start, picture::markup(what));
}

std::string line_classes(std::size_t series) {
  const std::size_t look = series % distinct_looks;
  return look == 0 ? "look-0" : fmt::format("look-{0} dash-{0}", look);
}

}  // namespace fathom::plot
