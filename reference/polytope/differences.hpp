// SPDX-License-Identifier: GPL-3.0-or-later
// The implicit vertex set of P = B (+) (-A): all differences b - a of two clouds, at the cost of linear scans.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernels/filters/support.hpp"

namespace fathom::polytope {

/// The difference b - a, by the indices of a in A and of b in B.
using Difference = std::pair<std::uint32_t, std::uint32_t>;

/// The clouds must outlive it.
struct Differences {
  using Integer = mpz_class;

  const kernels::PointCloud& a;
  const kernels::PointCloud& b;
  std::size_t scans = 0;  ///< linear scans over both clouds so far

  [[nodiscard]] Vector operator[](Difference d) const { return b[d.second] - a[d.first]; }
  /// Returns a difference that maximises <u, p>; of several the one with the lowest indices.
  Difference extreme(const Vector& u);
  /// Returns a difference that is extreme in direction n by its image, without a guarantee.
  [[nodiscard]] Difference likely_extreme(const Vec3<double>& n) const {
    return {kernels::likely_extreme_point(a.images(), -n), kernels::likely_extreme_point(b.images(), n)};
  }
  /// Of both clouds, if they share one.
  [[nodiscard]] long exponent() const { return a.exponent(); }
};

/// What the points of one body weigh in a convex combination of differences: `side` is Difference::first for A.
std::vector<Weight> weights_of(std::span<const Difference> differences, std::span<const mpq_class> weights,
                               std::uint32_t Difference::*side);

// For checks of proofs, by the definitions and in exact arithmetic only.

/// h(u) = max_b <u,b> - min_a <u,a>.
mpz_class support_naive(std::span<const Vector> a, std::span<const Vector> b, const Vector& u);
/// The weighted sum; nullopt unless the weights are convex weights of the points.
std::optional<Vec3<mpq_class>> convex_combination(std::span<const Vector> points, std::span<const Weight> weights);

}  // namespace fathom::polytope
