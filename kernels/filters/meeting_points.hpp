// SPDX-License-Identifier: GPL-3.0-or-later
// Points where planes meet, and on which side of other planes they lie: exactly, behind a filter in
// binary64; or by their images alone.
//                                                               [proofs/kernels.md, "Error bounds"]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <type_traits>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/number/fixed_integer.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

// The integers of planes through differences of lattice points, of the points where these planes
// meet, and of what is computed from them: of any size, or of fixed size where the lattice is
// narrow.                                                      [proofs/unions.md, "Fixed integers"]

struct AnyNumbers {
  using OfPlane = mpz_class;
  using OfPoint = mpz_class;
  using Product = mpz_class;
};

/// For coordinates of lattice points up to 2^w in size, w <= most_bits.
struct FixedNumbers {
  static constexpr long most_bits = 103;
  using OfPlane = FixedInteger<320>;   ///< at most 3w + 9 bits
  using OfPoint = FixedInteger<960>;   ///< at most 9w + 20
  using Product = FixedInteger<3584>;  ///< at most 34w + 82
};

/// The same number or vector in other integers. A FixedInteger that is too narrow throws.
template <class Integer, class From>
decltype(auto) as(const From& number) {
  if constexpr (std::is_same_v<Integer, From>) return static_cast<const From&>(number);
  else if constexpr (std::is_same_v<Integer, mpz_class>) return number.to_mpz();
  else return Integer(number);
}
template <class Integer, class From>
decltype(auto) as(const Vec3<From>& v) {
  if constexpr (std::is_same_v<Integer, From>) return static_cast<const Vec3<From>&>(v);
  else return Vec3<Integer>{as<Integer>(v.x), as<Integer>(v.y), as<Integer>(v.z)};
}

/// Both sides of a plane's equation, scaled by powers of 2; the largest component of the normal
/// lies in [1/2, 1].
struct PlaneImage {
  Vec3<double> normal{};
  double height = 0;
};

/// The plane <normal, x> = height, and its image.
template <class Numbers>
struct OrientedPlaneIn {
  Vec3<typename Numbers::OfPlane> normal;  ///< primitive, or without a common factor with the height
  typename Numbers::OfPlane height;
  PlaneImage image;

  [[nodiscard]] OrientedPlaneIn reversed() const { return {-normal, -height, {-image.normal, -image.height}}; }
};
using OrientedPlane = OrientedPlaneIn<AnyNumbers>;

/// The plane, its equation divided by what its numbers share: so the normal is primitive, if the
/// plane goes through a lattice point. Points that it is asked about have coordinates of size about
/// 2^exponent.
template <class Numbers = AnyNumbers>
OrientedPlaneIn<Numbers> oriented_plane(Vec3<typename Numbers::OfPlane> normal, typename Numbers::OfPlane height,
                                        long exponent);

/// The point v / w, w > 0, and its image, scaled by 2^-exponent: each coordinate errs by at most
/// 2^-49 of itself, and 2^-450.
template <class Numbers>
struct RationalPointIn {
  Vec3<typename Numbers::OfPoint> v;
  typename Numbers::OfPoint w = 1;
  Vec3<double> image{};
  double image_square = 0;  ///< |image|^2
};
using RationalPoint = RationalPointIn<AnyNumbers>;

template <class Numbers = AnyNumbers>
RationalPointIn<Numbers> rational_point(const Vec3<typename Numbers::Product>& v, const typename Numbers::Product& w,
                                        long exponent);

/// The same point in other integers.
template <class To, class From>
RationalPointIn<To> converted(const RationalPointIn<From>& p) {
  return {as<typename To::OfPoint>(p.v), as<typename To::OfPoint>(p.w), p.image, p.image_square};
}

/// A squared distance from O.
template <class Numbers>
struct SquaredDistanceIn {
  typename Numbers::Product numerator, denominator;
  double image;
};
using SquaredDistance = SquaredDistanceIn<AnyNumbers>;

template <class Numbers>
SquaredDistanceIn<Numbers> squared_distance(const RationalPointIn<Numbers>& p);

/// The sign of <normal, p> - height. Exact.
template <class Numbers>
int side(const OrientedPlaneIn<Numbers>& plane, const RationalPointIn<Numbers>& p);
/// The sign of p - q along coordinate `axis`: 0, 1, 2 for x, y, z. Exact.
template <class Numbers>
int compare(const RationalPointIn<Numbers>& p, const RationalPointIn<Numbers>& q, int axis);
/// The sign of |p|^2 - squared. Exact.
template <class Numbers>
int compare(const RationalPointIn<Numbers>& p, const SquaredDistanceIn<Numbers>& squared);
/// Whether the plane has O strictly below it, farther away than the distance. Exact.
template <class Numbers>
bool farther(const OrientedPlaneIn<Numbers>& plane, const SquaredDistanceIn<Numbers>& squared);

// The points where planes meet, in binary64 with a bound on the error: for searches that ask of
// most such points no more than which side of
// other planes they lie on.       [proofs/kernels.md, "Points where planes meet, without integers"]

/// The image of a point: each coordinate errs by at most `error`. If that is no finite number,
/// nothing is known.
struct PointImage {
  Vec3<double> at{};
  double error = 0;
};

/// The point of a plane that is nearest to O.
PointImage foot_image(const PlaneImage& g);

/// The line in which two planes meet, which must outlive it, by their images alone.
class MeetingLine {
 public:
  MeetingLine(const PlaneImage& g, const PlaneImage& h);

  /// True only if the planes are not parallel.
  [[nodiscard]] bool surely_exists() const;
  /// Its point nearest to O.
  [[nodiscard]] PointImage foot() const;
  /// The sign of <g x h, e> for the normals; nullopt if unsure.
  [[nodiscard]] std::optional<Sign> leads_beyond(const PlaneImage& e) const;
  /// The point where all three meet.
  [[nodiscard]] PointImage meeting(const PlaneImage& e) const;

 private:
  const PlaneImage &g_, &h_;
  Vec3<double> direction_;
};

/// The sign of <normal, p> - height; nullopt if unsure.
std::optional<Sign> sure_side(const PlaneImage& plane, const PointImage& p);
/// The sign of |p|^2 - squared; nullopt if unsure.
std::optional<Sign> sure_order(const PointImage& p, double squared);

}  // namespace fathom::kernels
