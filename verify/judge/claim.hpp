// SPDX-License-Identifier: GPL-3.0-or-later
// A reply in exact numbers and in fathom's conventions: the depth of overlapping bodies is
// positive, and A moves. For bodies that are claimed to be apart, the distance takes the place of
// the depth. And the allowances for errors of a reply. [proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/judge.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {

/// Returns a length in another unit, exactly: value * 2^exponent.
mpq_class scaled(const mpq_class& value, long exponent);

/// The points with all coordinates times 2^exponent; in binary64 if they were and are.
GivenPoints scaled(const GivenPoints& points, long exponent);

struct Claim {
  bool overlap = false;
  bool finite = true;  ///< whether all numbers of the answer are finite, if it has a length
  // These are nullopt if the number is absent or not finite; and all of them if the bodies are
  // claimed to be apart, without a distance:
  std::optional<mpq_class> length;            ///< the depth, or the distance
  std::optional<Vector> direction;            ///< primitive, of A's motion; nullopt also if it is zero
  std::optional<mpq_class> direction_length;  ///< squared, of the direction as given
  std::optional<Point> witness_a, witness_b;
  std::vector<Point> contacts;                           ///< empty if a number of theirs is not finite
  std::vector<std::optional<mpq_class>> contact_depths;  ///< of each of them
  std::set<std::size_t> outside;  ///< contacts found to be outside, which are not measured further

  /// Returns how far a contact may be from a body: minus its depth if that is negative, because the
  /// bodies touch there only later; else 0.
  [[nodiscard]] mpq_class gap(std::size_t contact) const {
    const std::optional<mpq_class>& depth = contact_depths[contact];
    return depth && sgn(*depth) < 0 ? mpq_class(-*depth) : mpq_class(0);
  }
  /// Returns the translation of A along a unit direction after which the bodies touch. There must
  /// be a length.
  [[nodiscard]] mpq_class way() const { return overlap ? *length : mpq_class(-*length); }
};

/// Returns the largest depth of a contact less the length; nullopt if no contact has a depth.
std::optional<mpq_class> deepest_contact(const Claim& claim);

/// Returns the number by which a reply is judged: its depth, or its distance; null without one.
const double* length_of(const Reply& reply);

/// Returns the claim of any reply. The reply's lengths are 2^exponent times those of the claim.
Claim exact_claim(const Reply& reply, const Conventions& conventions, long exponent = 0);

/// Returns the exact point. The coordinates must be finite.
Point exact_point(const Triple& p);
bool is_finite(const Triple& p);
bool is_finite(const ContactPoint& contact);

// ---- the allowances for errors of an answer, compared exactly as square roots ----

/// Upper bounds for the residuals of an optimum whose numbers are rounded.
struct Slack {
  mpq_class depth;      ///< |d - depth|
  mpq_class direction;  ///< |d - separating distance|, and exit distance - d
  mpq_class witness;    ///< the distance of a witness point from its body
  mpq_class gap;        ///< by which (b - a) misses the translation
};

/// Returns the slack of an answer whose numbers (depth, unit direction, witness points) are each
/// off by at most `ulps` ulps, or by half an ulp, as after correct rounding, if that is more.
Slack rounding_slack(const Sizes& sizes, const mpq_class& depth_squared, const NumberFormat& format,
                     unsigned long ulps);

/// An allowance for a residual: max(relative * depth, fixed). Lengths are given as rationals d, or
/// as signed squares s, for sqrt(s) or -sqrt(-s).
class Allowance {
 public:
  Allowance() = default;
  /// Negative values count as 0.
  Allowance(const mpq_class& relative, const mpq_class& depth_squared, const mpq_class& fixed);

  /// Returns whether d - length, length - d, or either of them exceeds the allowance.
  [[nodiscard]] bool above(const mpq_class& d, const mpq_class& length) const;
  [[nodiscard]] bool below(const mpq_class& d, const mpq_class& length) const;
  [[nodiscard]] bool off(const mpq_class& d, const mpq_class& length) const {
    return above(d, length) || below(d, length);
  }
  /// Returns whether a length, given by its square, is within the allowance.
  [[nodiscard]] bool negligible(const Surd& squared) const;
  [[nodiscard]] bool negligible(const mpq_class& squared) const { return squared <= squared_; }
  /// Returns whether it is within the sum of the allowance and another length >= 0.
  [[nodiscard]] bool negligible(const mpq_class& squared, const mpq_class& beside) const;
  [[nodiscard]] const mpq_class& squared() const { return squared_; }

 private:
  /// proportional_ = (relative * depth)^2; squared_ is the square of the larger one
  mpq_class fixed_, proportional_, squared_;
};

/// The allowance of each residual: the tolerance or the slack, whichever is larger; for
/// `classification` the tolerance alone.
struct Allowances {
  Allowances(const Sizes& sizes, const mpq_class& depth_squared, const NumberFormat& format,
             const Tolerance& tolerance);

  Allowance classification, depth, direction, witness, gap;
};

/// Returns the distance between consecutive numbers of the format's answers at sqrt(squared), as if
/// exponents had no upper limit.
mpq_class ulp_at_root(const mpq_class& squared, const NumberFormat& format);

/// Returns 2^-53 or 2^-24.
mpq_class unit_roundoff(Precision precision);

/// Returns the best class of a depth d that is within the tolerance; u_r is u R.
Accuracy accuracy_of(const mpq_class& d, const mpq_class& depth_squared, const mpq_class& u_r,
                     const NumberFormat& format);

}  // namespace fathom::judging
