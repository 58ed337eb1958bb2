// SPDX-License-Identifier: GPL-3.0-or-later
// Points where planes meet, and on which side of other planes they lie: by binary64 with an error bound, and exactly where that cannot
// tell.                                                                                     [proofs/kernels.md, "Error bounds"]
#pragma once

#include "kernels/filters/error_bounds.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// The plane <normal, x> = height, and its image: both sides of the equation scaled by powers of 2.
struct OrientedPlane {
  Vector normal;  ///< primitive
  mpz_class height;
  Vec3<double> image_normal{};
  double image_height = 0;

  [[nodiscard]] OrientedPlane reversed() const { return {-normal, -height, -image_normal, -image_height}; }
};

/// The plane with its normal made primitive; the plane goes through a lattice point, so that height stays an integer. Points that it is
/// asked about have coordinates of size about 2^exponent.
OrientedPlane oriented_plane(Vector normal, mpz_class height, long exponent);

/// The point v / w, w > 0, and its image, scaled by 2^-exponent: each coordinate errs by at most 2^-49 of itself, and 2^-450.
struct RationalPoint {
  Vector v;
  mpz_class w = 1;
  Vec3<double> image{};
  double image_square = 0;  ///< |image|^2
};

RationalPoint rational_point(Vector v, mpz_class w, long exponent);

/// A squared distance from O.
struct SquaredDistance {
  mpz_class numerator, denominator;
  double image;
};

SquaredDistance squared_distance(const RationalPoint& p);

/// The sign of <normal, p> - height. Exact.
int side(const OrientedPlane& plane, const RationalPoint& p);
/// The sign of |p|^2 - squared. Exact.
int compare(const RationalPoint& p, const SquaredDistance& squared);
/// Whether the plane has O strictly below it, farther away than the distance. Exact.
bool farther(const OrientedPlane& plane, const SquaredDistance& squared);

}  // namespace fathom::kernels
