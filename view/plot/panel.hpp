// SPDX-License-Identifier: GPL-3.0-or-later
// One panel of a figure.
#pragma once

#include <string>

#include "view/plot/plot.hpp"

namespace fathom::plot {

inline constexpr double panel_width = 760, panel_margin = 12;

struct PanelPicture {
  std::string content;  ///< elements, with the panel's left upper corner at the origin
  double height;
};

/// The text as markup, cut where it would not fit into the figure.
std::string fitting(const std::string& text);

/// `clip` is the id for its clipping path.
PanelPicture panel_picture(const CurvePanel& panel, const std::string& clip);

}  // namespace fathom::plot
