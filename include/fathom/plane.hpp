// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of the plane: polygons, points, segments, circles, capsules, rounded polygons,
// half-planes, and unions of polygons.                                          [proofs/plane.md]
//
// Such a body is a Body whose dimension is 2. exact_answer, contact_geometry, overlap, closer_than
// and what approximate.hpp says of bodies take them; what takes bodies of space alone throws
// std::invalid_argument at them. In an answer every z is 0, and a contact is that of vertices and
// edges. The width of a convex body is its depth against itself: exact_answer(body, body).
#pragma once

#include "fathom/body.hpp"

namespace fathom {

/// Returns the body as one of the plane. Points and radii stay: a sphere is a circle, a
/// half-space a half-plane; of a mesh the points alone are kept. Throws std::invalid_argument if
/// a z is not 0, a core is curved, or the body is the solid of a mesh.
Body in_plane(Body body);

}  // namespace fathom
