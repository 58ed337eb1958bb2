// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the stages of two bodies.
// Output  their charts as an SVG file, in longitude and latitude, where walls are vertical and a
//         hemisphere fits a square. A's arcs are solid and B's dashed; what is lit is thick. Pixels
//         are placed by doubles: the exact data stand elsewhere.
//                                                               [AGHRS, section 2.2, "Computing F"]
//
// First arcs of great circles, the parts of them in a hemisphere, and how they look in a
// projection.
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

/// An arc of a diagram; nullopt if its ends are too near each other to be seen apart.
std::optional<SphereArc> arc_of(const StagedBody& body, Index edge);

/// The parts in the hemisphere around z; all of it if it lies on the equator.
std::vector<SphereArc> parts_in(const SphereArc& arc, const Place& z);

/// A place in pixels.
struct Pixel {
  double x, y;
};

using Projection = std::function<Pixel(const Place&)>;

/// The arc as a line of pixels, which is off by less than half a pixel.
std::vector<Pixel> polyline(const SphereArc& arc, const Projection& project);

/// One hemisphere as a square of longitude and latitude.
struct ChartPanel {
  std::string content;   ///< elements, with the left upper corner at the origin
  std::string caption;   ///< what is seen: a sentence, as plain text
  std::string left_out;  ///< sentences on what is not drawn, as plain text; may be empty
};

/// The canonical pair that a picture of this chart lights unless another is asked for: that with
/// the optimum, else the one with most crossings, the first of several.
std::optional<Index> pair_to_light(const Stages& stages, Index chart);

ChartPanel chart_panel(const Stages& stages, Index chart, std::optional<Index> pair);

/// Both charts side by side, as a file of its own. Throws std::invalid_argument if the stages have
/// no charts.
std::string charts_file(const Stages& stages);

}  // namespace fathom::stages
