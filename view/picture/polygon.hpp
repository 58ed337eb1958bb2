// SPDX-License-Identifier: GPL-3.0-or-later
// Paths and convex polygons of a picture: cut at a box, and around dots. For doubles, and for exact
// places where doubles would not do.
#pragma once

#include <utility>
#include <vector>

#include "view/picture/view.hpp"

namespace fathom::picture {

/// The part of a path, or of a closed convex polygon, that lies between `low` and `high`. Of an
/// open path a segment is expected. Empty if a place is not finite.
std::vector<Dot> clipped(std::vector<Dot> path, bool closed, const Dot& low, const Dot& high);
std::vector<Spot> clipped(std::vector<Spot> path, bool closed, const Spot& low, const Spot& high);

/// The corners of the convex hull, in order. Of doubles for filling: rounding may keep or lose a
/// corner that is almost flat.
std::vector<Dot> outline(std::vector<Dot> dots);
std::vector<Spot> outline(std::vector<Spot> places);

/// The boundary of the union of convex polygons, each in the order that `outline` gives, as
/// segments: of each side what lies in no other polygon and is not the seam between two. For
/// drawing.
std::vector<std::pair<Dot, Dot>> united_outline(const std::vector<std::vector<Dot>>& polygons);

}  // namespace fathom::picture
