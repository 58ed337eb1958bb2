// SPDX-License-Identifier: GPL-3.0-or-later
// Where points lie about the plane through three of them. `Plane` decides, for questions asked many
// times among points of one set: doubles with a bound on the error, then intervals, integers when
// the interval holds zero. `RoundedPlane` is what an expanding polytope asks first: it knows images
// alone, returns the answers that are certain and says when none is. Last, the images of integers
// in place.                                                    [proofs/kernels.md, "Plain doubles"]
#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/fixed_integer.hpp"
#include "kernels/number/word_integer.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// Integer points with enclosures in one common scale. Refers to the points, which must outlive it.
class BoxedPoints {
 public:
  explicit BoxedPoints(std::span<const Vector> exact);

  [[nodiscard]] const Vector& exact(std::uint32_t i) const { return exact_[i]; }
  [[nodiscard]] const Vec3<DoubleInterval>& box(std::uint32_t i) const { return boxes_[i]; }
  /// In [-1, 1], within 2^-53 of the exact coordinates in that scale.
  [[nodiscard]] const Vec3<double>& rounded(std::uint32_t i) const { return images_[i]; }

 private:
  std::span<const Vector> exact_;
  std::vector<Vec3<DoubleInterval>> boxes_;
  std::vector<Vec3<double>> images_;
};

/// The oriented plane through points p, q, r; n = (q - p) x (r - p) points to the side from which
/// they appear counter-clockwise. Refers to the points, which must outlive it. Not to be shared
/// between threads: answers are remembered.
class Plane {
 public:
  Plane(const BoxedPoints& points, std::uint32_t p, std::uint32_t q, std::uint32_t r);

  /// The sign of <n, s - p>.
  [[nodiscard]] Sign side(std::uint32_t s) const { return rise(p_, s); }
  /// The sign of <n, t - s>: positive if t lies higher than s.
  [[nodiscard]] Sign rise(std::uint32_t s, std::uint32_t t) const;
  /// Whether p, q, r lie on one line: n = 0.
  [[nodiscard]] bool degenerate() const;
  /// n exactly, not reduced.
  [[nodiscard]] const Vector& normal() const;

 private:
  [[nodiscard]] const Vec3<DoubleInterval>& box() const;

  const BoxedPoints* points_;
  std::uint32_t p_, q_, r_;
  Vec3<double> image_;   // of n, up to the points' scale
  double size_, error_;  // the image's largest component, and a bound on the error of each
  mutable std::optional<Vec3<DoubleInterval>>
      box_;  // of n, in the same scale. Computed when the image is unsure for the first time
  mutable std::optional<Vector> normal_;  // Computed when the box is unsure for the first time
};

/// The points as seen along coordinate `axis` (0, 1, 2 for x, y, z) from its positive end, where
/// the two coordinates that follow it cyclically point right and up: positive if p, q, r turn left,
/// zero if they lie on one line.
Sign turn(const BoxedPoints& points, int axis, std::uint32_t p, std::uint32_t q, std::uint32_t r);

/// Returns an upper bound of sqrt(numerator / denominator) * 2^-exponent, a few roundings above it:
/// of all numbers with these first bits. `numerator` >= 0, `denominator` > 0.
double root_from_above(const Leading& numerator, const Leading& denominator, long exponent);
inline double root_from_above(mpz_srcptr numerator, mpz_srcptr denominator, long exponent) {
  return root_from_above(leading(numerator), leading(denominator), exponent);
}
inline double root_from_above(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  return root_from_above(numerator.get_mpz_t(), denominator.get_mpz_t(), exponent);
}

/// The oriented plane through points p, q, r of which only images are known, within 2^-52 and of
/// size at most 2; n = (q - p) x (r - p). What it says of sides and of distance holds for the exact
/// points, in every rounding mode.                                              [proofs/kernels.md]
class RoundedPlane {
 public:
  RoundedPlane(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& r);

  /// The sign of <n, s - p>; nullopt if unsure.
  [[nodiscard]] std::optional<Sign> side(const Vec3<double>& s) const;
  /// True only if <n, p> > radius * |n| for certain: O lies below the plane, farther from it than
  /// `radius` >= 0.
  [[nodiscard]] bool surely_beyond(double radius) const;
  /// An estimate of <n, p> / |n|, finite, without an error bound.
  [[nodiscard]] double estimated_distance() const { return distance_; }
  /// An estimate of n, up to its length, without an error bound.
  [[nodiscard]] const Vec3<double>& estimated_normal() const { return n_; }
  /// Whether the estimates are likely to be good to a few digits at least.
  [[nodiscard]] bool trustworthy() const { return trustworthy_; }

 private:
  /// The error bound of the computed <n, w>, for a w with this largest component.
  [[nodiscard]] double error(double length) const { return error_.slope * length + error_.floor; }

  Vec3<double> p_, n_;
  error_bound::WidePlane error_;
  double height_, length_;  // <n,p> from below, |n| from above
  double distance_;
  bool trustworthy_;
};

// Images of integers in place: the same values as those of mpz_class, which are their naive twins.

/// c * 2^-exponent, truncated to 53 bits; 0 below 2^-500. |c| < 2^(exponent + 500).
template <unsigned Bits>
double image(const FixedInteger<Bits>& c, long exponent) {
  const int n = c.limb_count();
  if (n == 0) return 0;
  const mp_limb_t* limbs = c.limbs();
  const int zeros = std::countl_zero(limbs[n - 1]);
  mp_limb_t top = limbs[n - 1] << zeros;
  if (n > 1 && zeros > 0) top |= limbs[n - 2] >> (64 - zeros);
  const auto mantissa = static_cast<double>(static_cast<std::int64_t>(top >> 11));  // 53 bits: exact
  const long power = 64L * n - zeros - 53 - exponent;
  if (power + 53 < -500) return 0;
  const double magnitude = mantissa * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + power) << 52);
  return c.size() < 0 ? -magnitude : magnitude;
}

/// The same for a word. `exponent` lies in [0, 400].
inline double image(std::int64_t c, long exponent) {
  const std::uint64_t magnitude = c < 0 ? -static_cast<std::uint64_t>(c) : static_cast<std::uint64_t>(c);
  const int beyond = 11 - std::countl_zero(magnitude);  // bits beyond 53
  const std::int64_t kept =
      beyond > 0 ? static_cast<std::int64_t>(magnitude >> beyond << beyond) : static_cast<std::int64_t>(magnitude);
  const double scaled =
      static_cast<double>(kept) * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - exponent) << 52);
  return c < 0 ? -scaled : scaled;
}

/// The same for a word integer. `exponent` lies in [0, 400].
template <WordInteger T>
double image(const T& c, long exponent) {
  const long beyond = std::max(c.bit_length() - 53, 0L);
  const double unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + beyond - exponent) << 52);
  const double size = static_cast<double>(static_cast<std::int64_t>(c.leading(beyond))) * unit;
  return sgn(c) < 0 ? -size : size;
}

/// Integers in place know how many bits they have: FixedInteger and WordInteger.
template <class T>
concept IntegerInPlace = requires(const T& c) {
  { c.bit_length() } -> std::same_as<long>;
};

template <IntegerInPlace T>
Vec3<double> image(const Vec3<T>& v, long exponent) {
  return {image(v.x, exponent), image(v.y, exponent), image(v.z, exponent)};
}

/// The largest number of bits of a component.
template <IntegerInPlace T>
long bit_length(const Vec3<T>& v) {
  return std::max({v.x.bit_length(), v.y.bit_length(), v.z.bit_length()});
}

/// The image of u, not zero, for points of which `exponent` is the exponent.
template <IntegerInPlace T>
DirectionImage direction_image_for(const Vec3<T>& u, long exponent) {
  const long bits = bit_length(u);
  const Vec3<double> v = image(u, bits);
  return {v.x, v.y, v.z, slack_of(bits + exponent)};
}

/// The least e >= 0 with |c| <= 2^e, for a number; for every component.
template <unsigned Bits>
long binary_exponent(const FixedInteger<Bits>& c) {
  const long bits = c.bit_length();
  return bits > 0 && static_cast<long>(c.trailing_zeros()) == bits - 1 ? bits - 1 : bits;
}
template <unsigned Bits>
long binary_exponent(const Vec3<FixedInteger<Bits>>& v) {
  return std::max({binary_exponent(v.x), binary_exponent(v.y), binary_exponent(v.z)});
}

/// f(x, y, exponent) of two integers that GMP reads where they are.
template <unsigned Bits, class Function>
double of_views(Function f, const FixedInteger<Bits>& x, const FixedInteger<Bits>& y, long exponent) {
  mpz_t of_x, of_y;
  x.view(of_x);
  y.view(of_y);
  return f(static_cast<mpz_srcptr>(of_x), static_cast<mpz_srcptr>(of_y), exponent);
}

/// As that of mpz_class.
template <unsigned Bits>
double root_from_above(const FixedInteger<Bits>& numerator, const FixedInteger<Bits>& denominator, long exponent) {
  const auto root = [](mpz_srcptr n, mpz_srcptr d, long e) { return root_from_above(n, d, e); };
  return of_views(root, numerator, denominator, exponent);
}

}  // namespace fathom::kernels
