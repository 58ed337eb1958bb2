// SPDX-License-Identifier: GPL-3.0-or-later
// A reply in exact numbers, and free of the conventions that it was given in: the depth of overlapping bodies is positive, and it is A
// that moves.
#pragma once

#include <gmpxx.h>

#include <optional>

#include "kernels/vector.hpp"
#include "verify/judge/reply.hpp"

namespace fathom {

struct Claim {
  bool overlap = false;
  bool finite = true;  ///< whether all numbers of the answer are, where it has a depth
  // Nothing where a number is absent or not finite:
  std::optional<mpq_class> depth;
  std::optional<Vector> direction;            ///< primitive, of A's motion; also nothing if it is zero
  std::optional<mpq_class> direction_length;  ///< squared, of the direction as given
  std::optional<Point> witness_a, witness_b;
};

/// Total.
Claim exact_claim(const Reply& reply, const Conventions& conventions);

/// The exact point. The coordinates must be finite.
Point exact_point(const Triple& p);
bool is_finite(const Triple& p);

}  // namespace fathom
