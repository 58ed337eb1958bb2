// SPDX-License-Identifier: GPL-3.0-or-later
// Points where planes meet, and on which side of other planes they lie: by binary64 with an error bound, and exactly where that cannot
// tell.                                                                                     [proofs/kernels.md, "Error bounds"]
#pragma once

#include "kernels/filters/error_bounds.hpp"
#include "kernels/filters/meeting_points.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// Both sides of a plane's equation, scaled by powers of 2; the largest component of the normal lies in [1/2, 1].
struct PlaneImage {
  Vec3<double> normal{};
  double height = 0;
};

/// The plane <normal, x> = height, and its image.
template <class Numbers>
struct OrientedPlaneIn {
  Vec3<typename Numbers::OfPlane> normal;  ///< primitive
  typename Numbers::OfPlane height;
  PlaneImage image;

  [[nodiscard]] OrientedPlaneIn reversed() const { return {-normal, -height, {-image.normal, -image.height}}; }
};
using OrientedPlane = OrientedPlaneIn<AnyNumbers>;

/// The plane with its normal made primitive; the plane goes through a lattice point, so that height stays an integer. Points that it is
/// asked about have coordinates of size about 2^exponent.
template <class Numbers = AnyNumbers>
OrientedPlaneIn<Numbers> oriented_plane(Vec3<typename Numbers::OfPlane> normal, typename Numbers::OfPlane height, long exponent);

/// The point v / w, w > 0, and its image, scaled by 2^-exponent: each coordinate errs by at most 2^-49 of itself, and 2^-450.
template <class Numbers>
struct RationalPointIn {
  Vec3<typename Numbers::OfPoint> v;
  typename Numbers::OfPoint w = 1;
  Vec3<double> image{};
  double image_square = 0;  ///< |image|^2
};
using RationalPoint = RationalPointIn<AnyNumbers>;

template <class Numbers = AnyNumbers>
RationalPointIn<Numbers> rational_point(const Vec3<typename Numbers::Product>& v, const typename Numbers::Product& w, long exponent);

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
/// The sign of |p|^2 - squared. Exact.
template <class Numbers>
int compare(const RationalPointIn<Numbers>& p, const SquaredDistanceIn<Numbers>& squared);
/// Whether the plane has O strictly below it, farther away than the distance. Exact.
template <class Numbers>
bool farther(const OrientedPlaneIn<Numbers>& plane, const SquaredDistanceIn<Numbers>& squared);

}  // namespace fathom::kernels
