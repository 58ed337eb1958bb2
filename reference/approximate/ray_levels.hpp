// SPDX-License-Identifier: GPL-3.0-or-later
// The facet of a polytope P = B (+) (-A) that a ray leaves through, by descending both hierarchies: O(log m log n) steps whatever the
// shapes. For RayShooter, when portals take too long.                                                       [proofs/ray.md]
#pragma once

#include <array>
#include <vector>

#include "reference/approximate/ray_portal.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::approximate {

/// Returns the last portal, which lies in the facet. `anchors` are corners of a tetrahedron in 4 P, with the start of the ray strictly
/// inside; P is thickened as SupportOfSum says. Adds its steps to `support`.
Portal refine_by_levels(const std::array<Vector, 4>& anchors, const PushedRay& ray, SupportOfSum& support);

}  // namespace fathom::approximate
