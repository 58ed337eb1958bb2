// SPDX-License-Identifier: GPL-3.0-or-later
// Both bodies as integer points in one common unit: the form in which every later stage computes.
#pragma once

#include <optional>
#include <vector>

#include "kernels/filters/support.hpp"
#include "kernels/positions.hpp"
#include "kernels/vector.hpp"

namespace fathom::polytope {

/// A point p of either cloud stands for origin + p / denominator. Differences b - a, hence P = B (+) (-A), do not see `origin`;
/// it only keeps the integers small when the bodies lie far from O. Indices are those of the input.
struct PlacedPair {
  mpz_class denominator = 1;  ///< > 0
  Point origin;
  kernels::PointCloud a, b;  ///< with one exponent, the least

  /// Of both clouds: |c| <= 2^exponent for every coordinate c.
  [[nodiscard]] long exponent() const { return a.exponent(); }
  /// The rational position of a lattice point, or of lattice coordinates with a further divisor: origin + v / (denominator * divisor).
  /// `divisor` must not be zero.
  [[nodiscard]] Point position(const Vector& v, const mpz_class& divisor = 1) const;
};

/// Throws std::invalid_argument when a body is empty or a coordinate is not in lowest terms over a positive denominator.
void require_bodies(kernels::Positions a, kernels::Positions b);

/// On the lattice with the least denominator for which all points, taken from the first point of B, are integral; b[0] is zero. Exact.
/// The unit is never coarser than 1: a factor that all integers share stays.
/// Size: each integer has about as many bits as the common denominator of all points, times their extent.
/// Throws as require_bodies does, and InputError when place_if_slim returns nullopt and all integers together would take more than 256 MB.
PlacedPair place(kernels::Positions a, kernels::Positions b);

/// The same, if the common denominator is in proportion to the points: it has at most 4096 bits, or eight times as many as the widest
/// coordinate. Returns nullopt otherwise: the points' denominators share little, and fewer points would have a smaller lattice.
std::optional<PlacedPair> place_if_slim(kernels::Positions a, kernels::Positions b);

/// Integer points of two bodies as clouds with one exponent, the least: the denominator is 1, the origin O.
PlacedPair place_integers(std::vector<Vector> a, std::vector<Vector> b);

}  // namespace fathom::polytope
