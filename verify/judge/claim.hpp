// SPDX-License-Identifier: GPL-3.0-or-later
// A reply in exact numbers and in fathom's conventions: the depth of overlapping bodies is
// positive, and A moves. Of bodies that are said to be apart, the distance stands in the depth's
// place.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/judge.hpp"
#include "kernels/vector.hpp"

namespace fathom::judging {

/// Lengths in another unit, exactly: value * 2^exponent.
mpq_class scaled(const mpq_class& value, long exponent);

/// The points with all coordinates times 2^exponent; in binary64 if they were and are.
GivenPoints scaled(const GivenPoints& points, long exponent);

struct Claim {
  bool overlap = false;
  bool finite = true;  ///< whether all numbers of the answer are finite, if it has a length
  // nullopt if a number is absent or not finite; all of them if the bodies are said to be apart,
  // without a distance:
  std::optional<mpq_class> length;            ///< the depth, or the distance
  std::optional<Vector> direction;            ///< primitive, of A's motion; nullopt also if it is zero
  std::optional<mpq_class> direction_length;  ///< squared, of the direction as given
  std::optional<Point> witness_a, witness_b;
  std::vector<Point> contacts;  ///< empty if a number of theirs is not finite
  std::vector<mpq_class> contact_depths;

  /// The translation of A along a unit direction that makes the bodies touch. There must be a
  /// length.
  [[nodiscard]] mpq_class way() const { return overlap ? *length : mpq_class(-*length); }
};

/// The largest depth of a contact less the length; nullopt if there is none.
std::optional<mpq_class> deepest_contact(const Claim& claim);

/// The number that a reply is judged by: its depth, or its distance; null without one.
const double* length_of(const Reply& reply);

/// Defined for every reply. Its lengths are 2^exponent times those of the claim.
Claim exact_claim(const Reply& reply, const Conventions& conventions, long exponent = 0);

/// Returns the exact point. The coordinates must be finite.
Point exact_point(const Triple& p);
bool is_finite(const Triple& p);
bool is_finite(const ContactPoint& contact);

}  // namespace fathom::judging
