// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of bodies of the plane, made for the families. All are about one unit long, and their
// numbers are binary32, unless it is said otherwise: engines of the plane compute in those, and are
// made for such sizes. `n` is the number of points of each polygon.
#pragma once

#include <vector>

#include "fathom/files.hpp"
#include "verify/families/random.hpp"

namespace fathom::families {

/// Two bodies of the plane that have no id yet.
struct PlanePair {
  Body a, b;
};

// ---- random bodies ----

/// Hulls of points in the unit disc; B shifted by up to 1 along each axis.
PlanePair plane_random(Random& random, unsigned n);
/// Regular polygons of 3 to n corners, but for rounding; B has radius 1/2 to 1.
PlanePair plane_regular(Random& random, unsigned n);
/// Rectangles with corners in {0..4}^2; n is ignored.
PlanePair plane_boxes(Random& random, unsigned n);
/// Polygons of which one side is 2^-3 to 2^-10 of the other; in binary64.
PlanePair plane_thin(Random& random, unsigned n);
/// A random pair, 10^3 to 9 10^6 away from the origin along each axis: binary32 is coarse there.
PlanePair plane_far(Random& random, unsigned n);
/// Circles, capsules, and polygons with margins.
PlanePair plane_rounded(Random& random, unsigned n);
/// A point, a segment or a polygon, against such a one; at least one has no interior.
PlanePair plane_flat(Random& random, unsigned n);

// ---- ties ----

/// A regular polygon of an even number of corners against itself, or against a smaller copy about
/// the same centre.
PlanePair plane_ties(Random& random, unsigned n);
/// The same, B moved by 2^-k.
PlanePair plane_near_ties(Random& random, unsigned n);
/// A body against its equal, at the same place.
PlanePair plane_identical(Random& random, unsigned n);
/// B is a smaller copy of A inside A.
PlanePair plane_nested(Random& random, unsigned n);

// ---- from the contact: a vertex or an edge of A meets one of B ----

/// They touch.
PlanePair plane_touching(Random& random, unsigned n);
/// They are apart or overlap by about 2^-k.
PlanePair plane_nearly_touching(Random& random, unsigned n);
/// Edge in edge, exactly parallel, overlapping by about 2^-k.
PlanePair plane_parallel_edges(Random& random, unsigned n);
/// The same, B's edge tilted by a slope of 2^-k; in binary64.
PlanePair plane_tilted_edges(Random& random, unsigned n);

}  // namespace fathom::families
