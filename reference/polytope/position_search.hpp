// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest point of the cone that all differences b - a span, found without listing them: the search behind the position of O.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position_cone.hpp"

namespace fathom::polytope {

/// Searches the cone that all differences of two clouds span.
class ConeSearch {
 public:
  explicit ConeSearch(Differences& differences) : differences_(differences) {}

  /// A point of the cone as a combination of differences, and the residual to the target.
  struct Nearest {
    std::vector<Difference> support;
    std::vector<mpq_class> weights;  ///< > 0
    Lifted residual;                 ///< zero if the target is in the cone; else a proof that it is not, see below
  };

  /// Searches the cone of all (p, lift), p a difference, for `target`. If the target is not in it, the residual r is a positive multiple
  /// of target - nearest: <r, target> > 0 and <r, (p, lift)> <= 0 for every p. With lift = 1 and target (0, 1) the search stops
  /// early, with some r such that <r.v, p> < 0 for every p.
  /// `seeds`: some differences, at least one. Unless lift = 1, O must be a positive combination of them.
  /// Expected time linear in the number of points.                                                           [proofs/position.md]
  Nearest nearest(const Lifted& target, int lift, const std::vector<Difference>& seeds);

 private:
  ConeSearch(Differences& sample, std::uint64_t seed) : differences_(sample), seed_(seed), sample_(true) {}
  Nearest nearest_directly(const Lifted& target, int lift);
  Nearest nearest_by_sampling(const Lifted& target, int lift, const std::vector<Difference>& seeds);

  Differences& differences_;
  std::uint64_t seed_ = 0;  // fixed for a whole problem: the same input gives the same answer
  bool sample_ = false;     // of a larger problem: then the search may not stop early
};

}  // namespace fathom::polytope
