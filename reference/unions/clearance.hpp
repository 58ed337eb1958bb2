// SPDX-License-Identifier: GPL-3.0-or-later
// Input   closed convex cones { x : <n, x> <= 0 for all n of a list }.
// Output  whether they cover space. The tangent cones of the P_ij that touch a point cover it if and only if the point lies in the interior
//         of the union of these P_ij: then no translation near it leaves a gap.                                   [proofs/unions.md]
#pragma once

#include <vector>

#include "kernels/vector.hpp"

namespace fathom::unions {

/// The outward normals of a cone's facets, which lie in planes through O. Without facets it is the whole space.
using TangentCone = std::vector<Vector>;

/// Whether every point lies in one of the cones. Exact.
bool cover_space(const std::vector<TangentCone>& cones);

}  // namespace fathom::unions
