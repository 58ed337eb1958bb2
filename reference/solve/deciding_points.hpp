// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies whose denominators share little: over a common denominator every coordinate is as long as all of them together, though the answer
// hangs on a few points.
// Input   two bodies that have no slim lattice.
// Output  the answer to the few points that decide, proved to be that of all.                    [proofs/depth.md, "Deciding points"]
#pragma once

#include <optional>
#include <span>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"

namespace fathom {

/// The answer to all points: the same in every field as depth_by_method would give, but that extreme points are not counted, counters tell of
/// the deciding points, and where there is a choice (the inner polytope; the nearest points of parallel faces; direction and common point of
/// touching bodies) another one may be made. Returns nullopt where more than half of all points would decide.
std::optional<Depth> depth_by_deciding_points(Context& context, std::span<const Point> a, std::span<const Point> b, const Options& options);

/// Of a non-empty body, the indices of all points that maximise <u, p>, ascending. Exact, for any denominators.
std::vector<std::uint32_t> extreme_points(std::span<const Point> body, const Vector& u);

}  // namespace fathom
