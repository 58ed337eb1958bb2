// SPDX-License-Identifier: GPL-3.0-or-later
// Placing a body: an exact affine map, and the one rounding that a program in doubles would add.      [docs/command_line.md]
#pragma once

#include "fathom/shape.hpp"

namespace fathom::files {

using fathom::Pose;

/// Returns M p + t, exactly. M may be any matrix: it need be neither orthonormal nor regular.
Point placed(const Point& p, const Pose& pose);

/// Sets `point` to the nearest binary64 numbers, ties to even. Returns false if a coordinate is too large; then the point is unusable.
bool round_to_binary64(Point& point);

}  // namespace fathom::files
