// SPDX-License-Identifier: GPL-3.0-or-later
// The running minimum: which of the planes seen so far are nearest to O. Squared distances are
// compared, no root is taken.
#pragma once

#include <set>
#include <utility>

#include "kernels/vector.hpp"

namespace fathom::kernels {

/// The nearest planes <n,x> = c to O, with c > 0, and the directions of all of them. Exact; ties
/// are kept.
class NearestPlanes {
 public:
  NearestPlanes() = default;
  /// The planes at the squared distance numerator / denominator > 0 of which these are the
  /// primitive normals.
  NearestPlanes(mpz_class numerator, mpz_class denominator, std::set<Vector, LexicographicOrder> directions)
      : numerator_(std::move(numerator)), denominator_(std::move(denominator)), directions_(std::move(directions)) {}

  /// Takes the plane <normal,x> = height into account; `normal` may not be zero. Planes with height
  /// <= 0 are ignored: with O inside P none of them supports P. Returns whether the plane is among
  /// the nearest now.
  bool offer(const Vector& normal, const mpz_class& height);
  /// Whether height > 0 and the plane <normal,x> = height is farther from O than the nearest
  /// planes; false if there are none.
  [[nodiscard]] bool nearer_than(const Vector& normal, const mpz_class& height) const;

  [[nodiscard]] bool empty() const { return directions_.empty(); }
  /// numerator() / denominator() is the squared distance of the nearest planes, not in lowest
  /// terms. Only if not empty.
  [[nodiscard]] const mpz_class& numerator() const { return numerator_; }
  [[nodiscard]] const mpz_class& denominator() const { return denominator_; }
  /// Primitive normals of the nearest planes, in lexicographic order.
  [[nodiscard]] const std::set<Vector, LexicographicOrder>& directions() const { return directions_; }

 private:
  /// Compares the plane's distance with that of the nearest planes.
  [[nodiscard]] Sign compare(const Vector& normal, const mpz_class& height) const;

  mpz_class numerator_, denominator_ = 1;
  std::set<Vector, LexicographicOrder> directions_;
};

}  // namespace fathom::kernels
