// SPDX-License-Identifier: GPL-3.0-or-later
// A case made ready for walks over P, with P itself to compare.
#pragma once

#include <set>

#include "fathom/files.hpp"
#include "kernels/nearest.hpp"
#include "reference/polytope/hierarchy.hpp"
#include "tests/approximate/naive_rays.hpp"

namespace fathom::testing {

using NormalSet = std::set<Vector, LexicographicOrder>;

/// Both bodies with their hierarchies, and P itself.
struct ShallowScene {
  explicit ShallowScene(const Case& input)
      : placed(polytope::place(input.a.points, input.b.points)),
        hull_a(polytope::convex_hull(placed.a.points())),
        hull_b(polytope::convex_hull(placed.b.points())),
        a(hull_a),
        b(hull_b),
        sum(differences(placed)) {}
  polytope::PlacedPair placed;
  polytope::Polytope hull_a, hull_b;
  polytope::Hierarchy a, b;
  polytope::Polytope sum;
};

}  // namespace fathom::testing
