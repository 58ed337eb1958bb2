// SPDX-License-Identifier: GPL-3.0-or-later
// Input   closed convex cones { x : <n, x> <= 0 for all n of a list }.
// Output  whether they cover space. The tangent cones of the P_ij that touch a point cover it if and only if the point lies in the interior
//         of the union of these P_ij: then no translation near it leaves a gap.                                   [proofs/unions.md]
#pragma once

#include <vector>

#include "kernels/filters/rational_point.hpp"

namespace fathom::unions {

/// The planes through O of a cone's facets, with outward normals. Without planes it is the whole space.
using TangentCone = std::vector<const kernels::OrientedPlane*>;

/// Whether every point lies in one of the cones. Exact.
bool cover_space(const std::vector<TangentCone>& cones);

}  // namespace fathom::unions
