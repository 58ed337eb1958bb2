// SPDX-License-Identifier: GPL-3.0-or-later
// What every oracle answers, and the little that they share. Oracles solve the problem by other
// means than the pipeline: other libraries, or brute force. They are slow; tests compare with them
// exactly.
#pragma once

#include <iosfwd>
#include <set>
#include <span>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/vector.hpp"

namespace fathom::oracles {

using Directions = std::set<Vector, LexicographicOrder>;

/// squared: depth^2 in lowest terms, 0 unless penetrating. directions: of all optima, primitive,
/// sorted lexicographically; empty unless penetrating.
struct OracleAnswer {
  Status status = Status::disjoint;
  mpq_class squared;
  std::vector<Vector> directions;
  friend bool operator==(const OracleAnswer&, const OracleAnswer&) = default;
};

/// What the pipeline answered, to compare.
OracleAnswer answer_of(const Depth& depth);

/// For the messages of failing tests.
std::ostream& operator<<(std::ostream& out, const OracleAnswer& answer);

/// The half-space <normal, x> <= offset; the normal is not 0.
struct HalfSpace {
  Vector normal;
  mpq_class offset;
};

/// The answer for a P that is the intersection of these half-spaces (a flat P: with a pair of
/// opposite ones for each equation), or that touches each of them; the facets of P must be among
/// them. Half-spaces that touch P without being facets do no harm: when O is inside P, the ball
/// around O up to the nearest of them lies in P and so has no other supporting plane at its contact
/// with P than a facet's.
OracleAnswer nearest_half_spaces(std::span<const HalfSpace> half_spaces);

/// All points as multiples of 1 / denominator.
struct IntegerBodies {
  mpz_class denominator = 1;
  std::vector<Vector> a, b;
};
IntegerBodies integer_bodies(std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::oracles
