// SPDX-License-Identifier: GPL-3.0-or-later
// For bodies whose denominators share little: over a common denominator every coordinate would be
// as long as all of them together, but few points decide the answer.
// Input   two bodies that have no slim lattice.
// Output  the answer for the few points that decide, proved to be that for all.
//                                                              [proofs/depth.md, "Deciding points"]
#pragma once

#include <optional>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/positions.hpp"

namespace fathom::solve {

/// Returns the answer for all points. It equals that of depth_by_method, except that extreme points
/// are not counted, that counters are those of the deciding points, and that it may be another one
/// where several are right (the inner polytope; the nearest points of parallel faces; direction and
/// common point of touching bodies). Returns nullopt if more than half of all points would decide.
std::optional<Depth> depth_by_deciding_points(kernels::Context& context, kernels::Positions a, kernels::Positions b,
                                              const Options& options);

/// Returns the indices of all points of a non-empty body that maximise <u, p>, ascending. Exact,
/// for any denominators.
std::vector<std::uint32_t> extreme_points(kernels::Positions body, const Vector& u);

}  // namespace fathom::solve
