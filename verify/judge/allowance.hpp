// SPDX-License-Identifier: GPL-3.0-or-later
// How much an answer may be off, as exact comparisons of square roots.                                             [proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include "kernels/number/surd.hpp"
#include "verify/judge/judge.hpp"
#include "verify/judge/scene.hpp"

namespace fathom {

/// The most by which the residuals of an optimum are off once its numbers are rounded: an upper bound for each.
struct Slack {
  mpq_class depth;      ///< |d - depth|
  mpq_class direction;  ///< |d - price|, and travel - d
  mpq_class witness;    ///< the distance of a witness point from its body
  mpq_class gap;        ///< how much (b - a) misses the translation
};

/// Of an answer each of whose numbers (depth, unit direction, witness points) is off by no more than `ulps` ulps, or half of one if that
/// is more: correct rounding to nearest.
Slack rounding_slack(const Sizes& sizes, const mpq_class& depth_squared, Precision precision, unsigned long ulps);

/// The length that a residual may have: max(relative * depth, fixed). Lengths come as rationals d, or as signed squares s: of sqrt(s),
/// of -sqrt(-s).
class Allowance {
 public:
  Allowance() = default;
  /// What is negative counts as 0.
  Allowance(const mpq_class& relative, const mpq_class& depth_squared, const mpq_class& fixed);

  /// d - length is more; length - d is more; either of them.
  [[nodiscard]] bool above(const mpq_class& d, const mpq_class& length) const;
  [[nodiscard]] bool below(const mpq_class& d, const mpq_class& length) const;
  [[nodiscard]] bool off(const mpq_class& d, const mpq_class& length) const { return above(d, length) || below(d, length); }
  /// A length that is no more; given by its square.
  [[nodiscard]] bool negligible(const Surd& squared) const;
  [[nodiscard]] bool negligible(const mpq_class& squared) const { return squared <= squared_; }
  [[nodiscard]] const mpq_class& squared() const { return squared_; }

 private:
  mpq_class fixed_, proportional_, squared_;  ///< proportional_ = (relative * depth)^2; squared_ is the square of the larger one
};

/// The tolerance alone, which classifications are judged by; and, residual by residual, the tolerance or the slack, whichever is larger.
struct Allowances {
  Allowances(const Sizes& sizes, const mpq_class& depth_squared, Precision precision, const Tolerance& tolerance);

  Allowance classification, depth, direction, witness, gap;
};

/// The distance from one number of the format to the next where sqrt(squared) lies, as if exponents had no upper end.
mpq_class ulp_at_root(const mpq_class& squared, Precision precision);

/// 2^-53 or 2^-24.
mpq_class unit_roundoff(Precision precision);

/// The best class that a depth of d is in which is within the tolerance; u_r is u R.
Accuracy accuracy_of(const mpq_class& d, const mpq_class& depth_squared, const mpq_class& u_r, Precision precision);

}  // namespace fathom
