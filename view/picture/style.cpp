// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/picture/style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace fathom::picture {
namespace {

struct Colour {
  std::string_view name, light, dark;
};

constexpr std::array<Colour, 11> colours{{
    {"ground", "#ffffff", "#14181d"},   // background
    {"ink", "#1b1f24", "#e6edf3"},      // text
    {"soft", "#57606a", "#9da7b1"},     // text beside it
    {"line", "#d0d7de", "#3d444d"},     // borders
    {"shade", "#f6f8fa", "#1d232a"},    // background of pictures and code
    {"a", "#0550ae", "#79c0ff"},        // body A
    {"b", "#8a4600", "#f0b072"},        // body B
    {"true", "#116329", "#56d364"},     // fathom's result
    {"claimed", "#a40e26", "#ff8f88"},  // others' claims
    {"link", "#0550ae", "#79c0ff"},     // links
    {"lit", "#8250df", "#d2a8ff"},      // the chosen element
}};

/// "@name" stands for a colour of that name.
constexpr std::string_view rules = R"(
svg.pair .wire,svg.pair .hidden,svg.pair .seam,svg.pair .ghost,svg.pair .shaft,svg.pair .feature,svg.pair .bar{fill:none;stroke-linejoin:round;stroke-linecap:round}
svg.pair .ground{fill:@shade}
svg.pair .toned.body-a{fill:@a;fill-opacity:.16}
svg.pair .toned.body-b{fill:@b;fill-opacity:.05}
svg.pair .stripe.body-b{fill:none;stroke:@b;stroke-width:1.1;stroke-opacity:.5}
svg.pair .wire{stroke-width:1.4}
svg.pair .hidden{stroke-width:.9;stroke-opacity:.6;stroke-dasharray:3 3}
svg.pair .toned.in-contact{fill-opacity:.2}
svg.pair .seam{stroke-width:.8;stroke-opacity:.75}
svg.pair .body-a.seam{stroke:@a}
svg.pair .body-b.seam{stroke:@b}
svg.pair .ghost{stroke:@a;stroke-width:1.2;stroke-dasharray:7 4}
svg.pair .feature{stroke-width:4.5}
svg.pair .body-a.wire,svg.pair .body-a.hidden,svg.pair .body-a.feature{stroke:@a}
svg.pair .body-b.wire,svg.pair .body-b.hidden,svg.pair .body-b.feature{stroke:@b}
svg.pair .body-a.dot,svg.pair .body-a.letter{fill:@a}
svg.pair .body-b.dot,svg.pair .body-b.letter{fill:@b}
svg.pair .shaft{stroke-width:2.6}
svg.pair .true.shaft{stroke:@true}
svg.pair .claimed.shaft{stroke:@claimed;stroke-dasharray:7 4;stroke-linecap:butt}
svg.pair .true.head,svg.pair .true.dot{fill:@true}
svg.pair .claimed.head,svg.pair .claimed.dot{fill:@claimed}
svg.pair .sum.toned{fill:@soft;fill-opacity:.12}
svg.pair .sum.wire,svg.pair .sum.hidden{stroke:@ink}
svg.pair .sum.wire{stroke-width:1.1}
svg.pair .ball{fill:@true;fill-opacity:.14;stroke:@true;stroke-width:1.4}
svg.pair .near{fill:@true;fill-opacity:.3;stroke:@true;stroke-width:3.5;stroke-linejoin:round}
svg.pair .origin{fill:@ink}
svg.pair .bar{stroke:@ink;stroke-width:1.4}
svg.pair text{fill:@ink;font-family:system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif;font-size:12px}
svg.pair .letter{font-size:18px;font-weight:700;text-anchor:middle;paint-order:stroke;stroke:@shade;stroke-width:4px;stroke-linejoin:round}
svg.pair .note,svg.pair .scale{paint-order:stroke;stroke:@shade;stroke-width:3px;stroke-linejoin:round}
svg.pair .note{fill:@soft}
svg.pair .paper{fill:@ground}
svg.pair .heading,svg.pair .answer{font-size:14px;font-weight:600}
svg.pair .caption{font-size:13px}
)";

std::string properties(std::string_view Colour::*shade) {
  std::string result;
  for (const Colour& colour : colours) result += fmt::format("--{}:{};", colour.name, colour.*shade);
  return result;
}

/// Returns the colour of a property in light pages: light_colour("a") is that of --a. Throws
/// std::out_of_range for other names.
std::string_view light_colour(std::string_view name) {
  const auto found = std::ranges::find(colours, name, &Colour::name);
  if (found == colours.end()) throw std::out_of_range("no colour is called " + std::string(name));
  return found->light;
}

}  // namespace

std::string colour_style() {
  return fmt::format(
      ":root{{color-scheme:light dark;{0}}}\n@media (prefers-color-scheme: dark){{:root{{{1}}}}}\n"
      "@media print{{:root{{color-scheme:light;{0}}}}}\n",
      properties(&Colour::light), properties(&Colour::dark));
}

// Two shadows are fixed at the edges; two covers of the background colour move with the scrolled
// content, and hide a shadow at the end of the content.
std::string_view scroll_style() {
  return R"(.wide { max-width: 100%; overflow-x: auto; background:
  linear-gradient(to right, var(--ground) 50%, transparent) left / 3rem 100% no-repeat local,
  linear-gradient(to left, var(--ground) 50%, transparent) right / 3rem 100% no-repeat local,
  linear-gradient(to right, var(--soft), transparent) left / .5rem 100% no-repeat scroll,
  linear-gradient(to left, var(--soft), transparent) right / .5rem 100% no-repeat scroll; }
@media print { .wide { overflow: visible; background: none; } }
)";
}

std::string coloured(std::string_view rules, bool plain) {
  std::string result;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i] != '@') {
      result += rules[i];
      continue;
    }
    const std::size_t end = rules.find_first_of(";}", i);
    const std::string_view name = rules.substr(i + 1, end - i - 1);
    const std::string property = result.substr(result.find_last_of("{;") + 1);
    if (plain) result += fmt::format("{};{}", light_colour(name), property);
    result += fmt::format("var(--{})", name);
    i = end - 1;
  }
  return result;
}

std::string picture_style() { return coloured(rules, false); }

std::string document_style() { return colour_style() + coloured(rules, true); }

}  // namespace fathom::picture
