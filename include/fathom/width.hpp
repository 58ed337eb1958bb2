// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a finite point set with rational coordinates; it stands for its convex hull.
// Output  the exact width of the hull: the least distance of two parallel planes that hold it
//         between them. [AGHRS, Proposition 2.1: width(P) = pi(P, P); Corollary 2.6]
#pragma once

#include <span>

#include "fathom/depth.hpp"

namespace fathom {

/// Returns the depth of the body against itself: squared() is the squared width, each optimum's
/// direction is normal to a pair of nearest supporting planes (and occurs with both signs),
/// contact.a spans one of the two faces and contact.b the other. A flat body has width 0 and status
/// touching. Throws as penetration_depth does.
Depth width(std::span<const Point> points, const Options& options = {});

}  // namespace fathom
