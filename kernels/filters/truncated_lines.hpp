// SPDX-License-Identifier: GPL-3.0-or-later
// A filter between binary64 and exact arithmetic, for lines of long coordinates: their first 256 bits decide for nearly every pair whether
// it is farther apart than a bound.                                             [proofs/closest_lines.md, "Long coordinates"]
#pragma once

#include <vector>

#include "kernels/vector.hpp"

namespace fathom::kernels {

/// Lines as integers of at most 256 bits: points times 2^(256 - exponent), directions each times a power of two of its own, truncated.
class TruncatedLines {
 public:
  /// Lines whose coordinates have fewer bits are compared exactly as fast.
  static constexpr long worth_it = 512;

  explicit TruncatedLines(long exponent) : exponent_(exponent) {}

  /// |coordinates of point| <= 2^exponent; direction not zero.
  void push_back(const Vector& point, const Vector& direction);

  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] const Vector& point(std::size_t i) const { return points_[i]; }
  [[nodiscard]] const Vector& direction(std::size_t i) const { return directions_[i]; }

  /// At least numerator / denominator, a squared distance of the lines before they were scaled.
  [[nodiscard]] mpz_class bound(const mpz_class& numerator, const mpz_class& denominator) const;

 private:
  long exponent_;
  std::vector<Vector> points_, directions_;
};

/// True only if line i of a and line j of b are strictly farther apart than `bound` allows. Both sets must have the same exponent.
bool surely_farther(const TruncatedLines& a, std::size_t i, const TruncatedLines& b, std::size_t j, const mpz_class& bound);

}  // namespace fathom::kernels
