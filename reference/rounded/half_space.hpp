// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a half-space, and the core of a shape that is a polytope: a sum of hulls of points.
// Output  the one optimal direction, and the support in it. No sum is expanded.  [proofs/shapes.md]
#pragma once

#include <span>
#include <vector>

#include "fathom/signed_depth.hpp"

namespace fathom::rounded {

enum class Side { a, b };

/// The half-space is the body on `side`. Every atom of the other body must be a point.
PlaneSupport plane_support(const HalfSpace& half, Side side, std::span<const Term> other);

}  // namespace fathom::rounded
