// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of square roots of rationals, and vectors of such numbers: is it zero? Roots of numbers whose ratio is the square of a rational are
// multiples of one another, and others are linearly independent over the rationals: so a sum is zero if and only if the factors of each
// class add up to zero.                                                                                       [proofs/shapes.md, "Study"]
#pragma once

#include <gmpxx.h>

#include <vector>

#include "kernels/vector.hpp"

namespace fathom::studies {

class RootSum {
 public:
  /// Adds factor * sqrt(square), square >= 0.
  void add(const mpq_class& factor, const mpq_class& square = 1);
  /// Adds times * the sum.
  void add(const RootSum& sum, const mpq_class& times = 1);
  [[nodiscard]] bool is_zero() const;

 private:
  struct Part {
    mpq_class square, factor;  ///< square > 0; the ratio of no two is a square
  };
  std::vector<Part> parts_;
};

using RationalVector = Vec3<mpq_class>;

inline RationalVector rational(const Point& p) { return {p.x, p.y, p.z}; }
inline RationalVector rational(const Vector& v) { return {v.x, v.y, v.z}; }
inline RationalVector scaled(const mpq_class& s, const RationalVector& v) { return {s * v.x, s * v.y, s * v.z}; }

/// The primitive integer vector along a vector other than 0.
Vector primitive_along(const RationalVector& v);

/// rational + sqrt(square) irrational.
struct RootVector {
  RationalVector rational, irrational;
  mpq_class square;
};

/// Whether one of them is a multiple of the other; so is 0.
bool parallel(const RootVector& u, const RootVector& v);

}  // namespace fathom::studies
