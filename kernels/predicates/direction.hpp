// SPDX-License-Identifier: GPL-3.0-or-later
// The operands of the predicates: exact directions with the enclosures that the interval filter reads.
#pragma once

#include "kernels/predicates/perturbation.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// A closed interval of binary64 numbers.
struct DoubleInterval {
  double low = 0, high = 0;
};

/// Encloses c / 2^shift. A c with at most 53 significant bits becomes a point, any other an interval between neighbours, but below
/// 2^-1022 there is a neighbour on either side. The quotient must be representable: shift at least the number of bits of c, less 1023.
DoubleInterval enclose(const mpz_class& c, long shift);

/// Encloses v times one positive power of two, chosen so that the largest component lies in [1/2, 1]: signs of homogeneous predicates
/// do not see the factor. A component with at most 53 significant bits becomes a point, any other an interval between neighbours; only
/// those below 2^-1022 after scaling get a neighbour on either side.
Vec3<DoubleInterval> enclose(const Vector& v);

/// An exact direction, not zero, and its role in the chart. Its length has no meaning.
class Direction {
 public:
  Direction() = default;
  explicit Direction(Vector exact, Role role = Role::fixed) : exact_(std::move(exact)), enclosure_(enclose(exact_)), role_(role) {}

  [[nodiscard]] const Vector& exact() const { return exact_; }
  [[nodiscard]] const Vec3<DoubleInterval>& enclosure() const { return enclosure_; }
  [[nodiscard]] Role role() const { return role_; }

 private:
  Vector exact_;
  Vec3<DoubleInterval> enclosure_;
  Role role_ = Role::fixed;
};

}  // namespace fathom::kernels
