// SPDX-License-Identifier: GPL-3.0-or-later
// The operands of the predicates: exact directions, the enclosures that the interval filter reads,
// and images in binary64.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/number/wide_float.hpp"
#include "kernels/predicates/perturbation.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// A closed interval of binary64 numbers.
struct DoubleInterval {
  double low = 0, high = 0;
};

/// Encloses c / 2^shift. A c with at most 53 significant bits becomes a point, any other an
/// interval between neighbours, but below 2^-1022 there is a neighbour on either side. The quotient
/// must be representable: shift at least the number of bits of c, less 1023.
DoubleInterval enclose(const mpz_class& c, long shift);

/// Encloses v times one positive power of two, chosen so that the largest component lies in [1/2,
/// 1]: signs of homogeneous predicates do not see the factor. A component with at most 53
/// significant bits becomes a point, any other an interval between neighbours; only those below
/// 2^-1022 after scaling get a neighbour on either side.
Vec3<DoubleInterval> enclose(const Vector& v);

/// An exact direction, not zero, and its role in the chart. Its length has no meaning.
class Direction {
 public:
  Direction() = default;
  explicit Direction(Vector exact, Role role = Role::fixed)
      : exact_(std::move(exact)), enclosure_(enclose(exact_)), role_(role) {}

  [[nodiscard]] const Vector& exact() const { return exact_; }
  [[nodiscard]] const Vec3<DoubleInterval>& enclosure() const { return enclosure_; }
  [[nodiscard]] Role role() const { return role_; }

 private:
  Vector exact_;
  Vec3<DoubleInterval> enclosure_;
  Role role_ = Role::fixed;
};

// The images of exact numbers in binary64, for all filters; and the signs that images of directions
// settle, for searches that ask one node or one arc about many arcs.
//                                                              [proofs/kernels.md, "Plain doubles"]

/// Images below 2^negligible_image are 0, so that no product of two underflows.
inline constexpr long negligible_image = -500;
/// c * 2^-exponent, truncated to 53 bits; the same of its first bits.
double image(const Leading& c, long exponent);
inline double image(const mpz_class& c, long exponent) { return image(leading(c.get_mpz_t()), exponent); }
Vec3<double> image(const Vector& v, long exponent);
/// With the exponent for which the largest component lies in [1/2, 1]. v is not zero. The image of
/// -v is the negative.
Vec3<double> direction_image(const Vector& v);

/// The lower ends: each within 2^-53 of what the box encloses, if that is in [-1, 1].
inline Vec3<double> image(const Vec3<DoubleInterval>& box) { return {box.x.low, box.y.low, box.z.low}; }

/// A direction in binary64: each component within 2^-53 of that of the exact one after scaling,
/// hence in [-1, 1].
inline Vec3<double> image(const Direction& d) { return image(d.enclosure()); }

/// The largest component in absolute value.
inline double largest(const Vec3<double>& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// The sign of a number of which `value` errs by `error` at most; nullopt if unsure.
inline std::optional<Sign> sure_sign(double value, double error) {
  if (value > error) return Sign::positive;
  if (value < -error) return Sign::negative;
  return std::nullopt;
}

/// The sign of <n,d>, for images or their negatives.
inline std::optional<Sign> sure_side_of_arc(const Vec3<double>& n, const Vec3<double>& d) {
  return sure_sign(dot(n, d), error_bound::product);
}

/// The point of arc d1 on the vertical through n: OrderOnVertical(d1, d2, n, v) = <c, d2> for c = n
/// <d1,v> - v <d1,n>.
class VerticalProbe {
 public:
  /// d1, n and v are images of directions, or the negatives of images.
  VerticalProbe(const Vec3<double>& d1, const Vec3<double>& n, const Vec3<double>& v) {
    const double s = dot(d1, v), t = dot(d1, n);
    c_ = {n.x * s - v.x * t, n.y * s - v.y * t, n.z * s - v.z * t};
  }

  /// The sign of OrderOnVertical(d1, d2, n, v). d2 as the others.
  [[nodiscard]] std::optional<Sign> sign(const Vec3<double>& d2) const {
    return sure_sign(dot(c_, d2), error_bound::order_on_vertical);
  }

 private:
  Vec3<double> c_;
};

}  // namespace fathom::kernels
