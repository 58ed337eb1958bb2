// SPDX-License-Identifier: GPL-3.0-or-later
// How much an answer may be off, as exact comparisons of square roots.                                             [proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include <optional>

#include "kernels/number/surd.hpp"
#include "verify/judge/judge.hpp"
#include "verify/judge/scene.hpp"

namespace fathom {

/// tol = max(relative * depth, absolute * extent, ulps * ulp(depth)). Negative parts of a tolerance count as 0. Lengths come as rationals
/// d, or as signed squares s: of sqrt(s), of -sqrt(-s).
class Allowance {
 public:
  Allowance(const Scene& scene, const Depth& depth, Precision precision, const Tolerance& tolerance);

  /// d - length > tol; length - d > tol; either of them.
  [[nodiscard]] bool above(const mpq_class& d, const mpq_class& length) const;
  [[nodiscard]] bool below(const mpq_class& d, const mpq_class& length) const;
  [[nodiscard]] bool off(const mpq_class& d, const mpq_class& length) const { return above(d, length) || below(d, length); }
  /// A length that is no more than tol; given by its square.
  [[nodiscard]] bool negligible(const Surd& squared) const;
  [[nodiscard]] bool negligible(const mpq_class& squared) const { return squared <= squared_; }

  [[nodiscard]] const mpq_class& ulp() const { return ulp_; }            ///< of the subject's precision, at the depth
  [[nodiscard]] const mpq_class& rounding_unit() const { return u_r_; }  ///< u R
  [[nodiscard]] const mpq_class& depth_squared() const { return depth_squared_; }

 private:
  mpq_class depth_squared_, ulp_, u_r_;
  mpq_class fixed_;         ///< max(absolute * extent, ulps * ulp)
  mpq_class proportional_;  ///< (relative * depth)^2
  mpq_class squared_;       ///< tol^2
};

/// The distance from one number of the format to the next where sqrt(squared) lies, as if exponents had no upper end.
mpq_class ulp_at_root(const mpq_class& squared, Precision precision);

/// 2^-53 or 2^-24.
mpq_class unit_roundoff(Precision precision);

/// The best class that a depth of d is in which is within the tolerance.
Accuracy accuracy_of(const mpq_class& d, const Allowance& allowance, Precision precision);

}  // namespace fathom
