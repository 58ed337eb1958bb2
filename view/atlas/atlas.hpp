// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the stages of two bodies.
// Output  static pictures of them as SVG: the charts, in longitude and latitude, where walls are vertical and a hemisphere fits a square;
// and
//         the sphere with both diagrams; P, or what stands for it, round O.                   [AGHRS, section 2.2, "Computing F"]
//
// A's arcs are solid and B's dashed; what is lit is thick. Pixels are placed by doubles: the exact data stand elsewhere.
#pragma once

#include <optional>
#include <string>

#include "view/stages/stages.hpp"
#include "view/stages/union_stages.hpp"

namespace fathom::atlas {

/// What a picture of the stages shows.
struct ChartView {
  std::optional<stages::Index> chart = std::nullopt;  ///< 0: the upper hemisphere, 1: the lower one; that of the pair or of the optimum
  std::optional<stages::Index> pair = std::nullopt;  ///< the canonical pair that is lit; that of the optimum, else the largest of the chart
};

/// One element <svg> for an HTML page that has atlas_style() and picture::colour_style(). `prefix` begins its ids: those of two pictures in
/// one page must differ. Empty if the stages have no charts. What is lit has the class "lit", one element for each arc.
std::string chart_picture(const stages::Stages& stages, const std::string& prefix, const ChartView& view = {});
std::string sphere_picture(const stages::Stages& stages, const std::string& prefix, const ChartView& view = {});

/// P, or Q, as drawn facets seen across the way out, with the outline of the ball round O and its nearest facets marked; in the style of
/// picture::picture_style.
struct SumPicture {
  std::string svg;   ///< one or two elements; empty if the stages have no sum
  std::string note;  ///< what is drawn and what is left out, in a sentence or two, without markup
};
SumPicture sum_picture(const stages::Stages& stages, const std::string& prefix);
/// Of unions the differences of the pieces that are in contact after the first way out.
SumPicture sum_picture(const stages::UnionStages& stages, const std::string& prefix);

/// Both charts side by side, as a file of its own. Throws std::invalid_argument if the stages have no charts.
std::string charts_file(const stages::Stages& stages);

/// The rules for the classes of these pictures, by the colours of picture::colour_style.
std::string atlas_style();

}  // namespace fathom::atlas
