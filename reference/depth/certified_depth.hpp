// SPDX-License-Identifier: GPL-3.0-or-later
// The depth by an expanding polytope: no hulls of the bodies, no decomposition, and the proof is there when the answer is.
#pragma once

#include <optional>

#include "kernels/filters/support.hpp"
#include "reference/depth/depth.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom {

/// The same answer as every other method gives, with `inner` set; extreme points are not counted. Nothing if O is not in the interior of P,
/// or past options.expansion_budget. The clouds are the lattice's points.
std::optional<Depth> certified_depth(const Lattice& lattice, const PointCloud& a, const PointCloud& b, const Options& options);

}  // namespace fathom
