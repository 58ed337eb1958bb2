// SPDX-License-Identifier: GPL-3.0-or-later
// A grid of rational directions that covers the sphere as densely as a (1 + delta)-approximation
// needs.
//                                         [AGHRS, APPROX-SEPARATION, step 1; proofs/approximate.md]
// Departs from the paper: directions are rational, one for each cell of a grid on the faces of a
// cube; and the criterion is tan^2(angle) <= 2 delta + delta^2, which is decided exactly and
// suffices for every delta > 0. [proofs/errata.md]
#pragma once

#include <array>
#include <cstdint>

#include "kernels/context.hpp"
#include "kernels/vector.hpp"

namespace fathom::approximate {

/// Whether <v,p> > 0 and (1 + delta)^2 <v,p>^2 >= |v|^2 |p|^2: then a ray along p is at most 1 +
/// delta times as long as the one along v to the plane whose normal is v.
bool covers(const Vector& p, const Vector& v, const mpq_class& delta);

/// The least delta that is accepted: smaller ones would need more directions than any run can try.
inline const mpq_class least_delta(1, 1'000'000'000);

/// Every v other than 0 lies in the cone of a cell, whose centre covers it.
class DirectionGrid {
 public:
  /// 6 directions at least; about 4 / delta for small delta. Deterministic.
  /// Throws std::invalid_argument unless delta >= least_delta. Throws Interrupted.
  DirectionGrid(kernels::Context& context, const mpq_class& delta);

  /// Of cells. Those from size() / 2 on are the opposites of those before, in another order.
  [[nodiscard]] std::uint64_t size() const { return 6 * side_ * side_; }
  /// Of cells along an edge of the cube.
  [[nodiscard]] std::uint64_t side() const { return side_; }
  /// The direction of the grid in that cell; primitive.
  [[nodiscard]] Vector centre(std::uint64_t cell) const;
  /// The four directions that span the cell's cone, in cyclic order; primitive.
  [[nodiscard]] std::array<Vector, 4> corners(std::uint64_t cell) const;

 private:
  std::uint64_t side_;
};

}  // namespace fathom::approximate
