// SPDX-License-Identifier: GPL-3.0-or-later
// The search of Gilbert, Johnson and Keerthi on the support of P: the point of the hull of one to three points of P that is nearest to O,
// while more points come.                                                                              [proofs/shapes_curved.md, lemma 3]
#pragma once

#include <utility>
#include <vector>

#include "reference/curved/oracle.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::curved {

enum class NearestEnd {
  common,  ///< the foot is O
  inside,  ///< O is in the interior of a tetrahedron of four corners; there is no foot
  near,    ///< `enough` said so
  open     ///< no further point, or no further call
};

struct NearestFoot {
  NearestEnd end;
  std::vector<polytope::SimplexCorner> corners;
  polytope::SimplexFoot foot;
};

/// Starts from a point that has been found. `enough` and `precision` are asked for each foot; the second says how fine the next point is.
template <class Enough, class Precision>
NearestFoot find_nearest(Oracle& oracle, polytope::Difference first, Enough enough, Precision precision) {
  NearestFoot result{NearestEnd::open, {{first, oracle[first]}}, {}};
  while (true) {
    auto foot = polytope::nearest_in_simplex(result.corners);
    if (!foot) {
      result.end = NearestEnd::inside;
      return result;
    }
    result.foot = std::move(*foot);
    const polytope::SimplexFoot& z = result.foot;
    if (is_zero(z.point) || enough(z)) {
      result.end = is_zero(z.point) ? NearestEnd::common : NearestEnd::near;
      return result;
    }
    const Vector n = oracle.shortened(-z.point);
    const mpz_class square = dot(z.point, z.point);
    bool found = false;  // a point that leads nearer
    for (unsigned fine : {precision(z), oracle.lattice().fine}) {
      if (found || oracle.spent()) break;
      const polytope::Difference next = oracle.ask(n, fine);
      found = z.denominator * dot(z.point, oracle[next]) < square;
      if (found) result.corners.push_back({next, oracle[next]});
    }
    if (!found) return result;
  }
}

}  // namespace fathom::curved
