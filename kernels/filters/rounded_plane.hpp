// SPDX-License-Identifier: GPL-3.0-or-later
// A plane through three points in binary64, with a bound on its error: it returns the answers that are certain, and says when none is.
#pragma once

#include <optional>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// Returns an upper bound of sqrt(numerator / denominator) * 2^-exponent, a few roundings above it. `numerator` >= 0, `denominator` > 0.
double root_from_above(mpz_srcptr numerator, mpz_srcptr denominator, long exponent);
inline double root_from_above(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  return root_from_above(numerator.get_mpz_t(), denominator.get_mpz_t(), exponent);
}

/// The oriented plane through points p, q, r of which only images are known, within 2^-52 and of size at most 2; n = (q - p) x (r - p).
/// What it says of sides and of distance holds for the exact points, in every rounding mode.          [proofs/kernels.md]
class RoundedPlane {
 public:
  RoundedPlane(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& r);

  /// The sign of <n, s - p>; nullopt if unsure.
  [[nodiscard]] std::optional<Sign> side(const Vec3<double>& s) const;
  /// True only if <n, p> > radius * |n| for certain: O lies below the plane, farther from it than `radius` >= 0.
  [[nodiscard]] bool surely_beyond(double radius) const;
  /// An estimate of <n, p> / |n|, finite, without an error bound.
  [[nodiscard]] double estimated_distance() const { return distance_; }
  /// An estimate of n, up to its length, without an error bound.
  [[nodiscard]] const Vec3<double>& estimated_normal() const { return n_; }
  /// Whether the estimates are likely to be good to a few digits at least.
  [[nodiscard]] bool trustworthy() const { return trustworthy_; }

 private:
  /// The error bound of the computed <n, w>, for a w with this largest component.
  [[nodiscard]] double error(double length) const { return error_.slope * length + error_.floor; }

  Vec3<double> p_, n_;
  error_bound::WidePlane error_;
  double height_, length_;  // <n,p> from below, |n| from above
  double distance_;
  bool trustworthy_;
};

}  // namespace fathom::kernels
