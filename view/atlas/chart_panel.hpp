// SPDX-License-Identifier: GPL-3.0-or-later
// One hemisphere as a square of longitude and latitude.
#pragma once

#include <optional>
#include <string>

#include "view/stages/stages.hpp"

namespace fathom::atlas {

inline constexpr double panel_width = 492, panel_height = 500;

struct ChartPanel {
  std::string content;   ///< elements, with the left upper corner at the origin
  std::string caption;   ///< what is seen: a sentence, as plain text
  std::string left_out;  ///< sentences on what is not drawn, as plain text; may be empty
};

/// The canonical pair that a picture of this chart lights unless another is asked for: that with the optimum, else the one with most
/// crossings, the first of several.
std::optional<stages::Index> pair_to_light(const stages::Stages& stages, stages::Index chart);

ChartPanel chart_panel(const stages::Stages& stages, stages::Index chart, std::optional<stages::Index> pair);

}  // namespace fathom::atlas
