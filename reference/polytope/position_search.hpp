// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest point of the cone that all differences b - a span, found without listing them: the search behind the position of O.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/filters/support.hpp"
#include "reference/polytope/position_cone.hpp"

namespace fathom {

/// Indices of a point a of A and a point b of B; stands for the difference b - a.
using Difference = std::pair<std::uint32_t, std::uint32_t>;

/// All differences b - a of two clouds, at the cost of linear scans. The clouds must outlive it.
class Differences {
 public:
  Differences(const PointCloud& a, const PointCloud& b) : a_(a), b_(b) {}

  [[nodiscard]] Vector operator[](Difference d) const { return b_[d.second] - a_[d.first]; }
  /// A difference that maximises <u, p>; of equals the one with the lowest indices.
  Difference extreme(const Vector& u);

  /// A point of the cone as a combination of differences, and what is missing to the target.
  struct Nearest {
    std::vector<Difference> support;
    std::vector<mpq_class> weights;  ///< > 0
    Lifted residual;                 ///< zero: the target is in the cone. Else a proof that it is not, see below.
  };

  /// Searches the cone of all (p, lift), p a difference, for `target`. If the target is not in it, the residual r is a positive multiple
  /// of target - nearest: <r, target> > 0 and <r, (p, lift)> <= 0 for every p. With lift = 1 and target (0, 1) the search stops
  /// early, with some r such that <r.v, p> < 0 for every p.
  /// `seeds`: some differences, at least one. Unless lift = 1, O must be a positive combination of them.
  /// Expected time linear in the number of points.                                                           [proofs/position.md]
  Nearest nearest(const Lifted& target, int lift, const std::vector<Difference>& seeds);

  /// Linear scans over both clouds so far.
  [[nodiscard]] std::size_t scans() const { return scans_; }

 private:
  const PointCloud& a_;
  const PointCloud& b_;
  std::uint64_t seed_ = 0;  // fixed for a whole problem: the same input gives the same answer
  bool sample_ = false;     // of a larger problem: then the search may not stop early
  std::size_t scans_ = 0;

  Differences(const PointCloud& a, const PointCloud& b, std::uint64_t seed) : a_(a), b_(b), seed_(seed), sample_(true) {}
  Nearest nearest_directly(const Lifted& target, int lift);
  Nearest nearest_by_sampling(const Lifted& target, int lift, const std::vector<Difference>& seeds);
};

}  // namespace fathom
