// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the stages of two bodies.
// Output  their charts as an SVG file, in longitude and latitude, where walls are vertical and a
//         hemisphere fits a square. A's arcs are solid and B's dashed; highlighted arcs are thick.
//         Places are computed in doubles: the exact data are elsewhere.
//                                                               [AGHRS, section 2.2, "Computing F"]
//
// First arcs of great circles, their parts in a hemisphere, and their projection.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "view/stages/stages.hpp"

namespace fathom::stages {

/// The points cos(t) from + sin(t) side for t in [begin, end]; `from` and `side` are orthogonal
/// unit vectors.
struct SphereArc {
  Place from, side;
  double begin, end;

  [[nodiscard]] Place at(double t) const;
};

/// Returns an arc of a diagram; nullopt if its ends are too close to each other to be
/// distinguished.
std::optional<SphereArc> arc_of(const StagedBody& body, Index edge);

/// Returns the parts in the hemisphere around z; all of the arc if it lies on the equator.
std::vector<SphereArc> parts_in(const SphereArc& arc, const Place& z);

/// A place in pixels.
struct Pixel {
  double x, y;
};

using Projection = std::function<Pixel(const Place&)>;

/// Returns the arc as a line of pixels, with an error of less than half a pixel.
std::vector<Pixel> polyline(const SphereArc& arc, const Projection& project);

/// One hemisphere as a square of longitude and latitude.
struct ChartPanel {
  std::string content;   ///< elements, with the upper left corner at the origin
  std::string caption;   ///< a sentence that describes the panel, as plain text
  std::string left_out;  ///< sentences on omitted parts, as plain text; may be empty
};

/// Returns the canonical pair that a picture of this chart highlights unless another is requested:
/// that with the optimum, else the one with the most crossings, the first of several.
std::optional<Index> pair_to_light(const Stages& stages, Index chart);

ChartPanel chart_panel(const Stages& stages, Index chart, std::optional<Index> pair);

/// Returns both charts side by side, as a file. Throws std::invalid_argument if the stages have no
/// charts.
std::string charts_file(const Stages& stages);

}  // namespace fathom::stages
