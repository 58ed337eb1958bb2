// SPDX-License-Identifier: GPL-3.0-or-later
#include "fathom/width.hpp"

namespace fathom {

Depth width(std::span<const Point> points, const Options& options) { return penetration_depth(points, points, options); }

}  // namespace fathom
