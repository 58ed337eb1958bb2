// SPDX-License-Identifier: GPL-3.0-or-later
// The width is the depth of a body against itself.
#include "fathom/width.hpp"

namespace fathom {

Depth width(std::span<const Point> points, const Options& options) { return penetration_depth(points, points, options); }

}  // namespace fathom
