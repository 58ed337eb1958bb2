// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of the floating-point filters. They hold in every rounding mode, for images within 2^-53 of values of size at most 1
// unless said otherwise.                                                                       [proofs/kernels.md, "Error bounds"]
#pragma once

namespace fathom::kernels::error_bound {

inline constexpr double unit = 0x1p-52;  ///< of one operation, relative to its result

// Absolute.

inline constexpr double product = 0x1p-48;                ///< of <n,d>
inline constexpr double determinant = 0x1p-46;            ///< of <a x b, c>
inline constexpr double order_on_vertical = 0x1p-44;      ///< of <d2,n><d1,v> - <d1,n><d2,v>, in either form
inline constexpr double rise = 0x1p-47;                   ///< of <u, q - p>, for points within 2^-52
inline constexpr double turn = 0x1p-44;                   ///< of a width times a rise, less another such product
inline constexpr double height_over_line = 96 * unit;     ///< of <p - q, d x e>
inline constexpr double squared_length = 112 * unit;      ///< of |d x e|^2
inline constexpr double difference_of_heights = 0x1p-46;  ///< of <u,p> - <u,q>, for exact u and images of rational points

// Of (q - p) x (r - p), and of its product with a step t - s, for points p, q, r, s, t. These follow the size of the triangle: u and v are
// the largest components of the computed edges, `size` that of the computed normal, `length` that of the computed step.

/// Of a component of the normal.
inline double normal(double u, double v) { return 0x1p-49 * (u + v + u * v) + 0x1p-98; }
/// Of the product, where `error` bounds that of the normal's components.
inline double height(double size, double error, double length) { return 0x1p-48 * size * (1 + length) + (4 * length + 0x1p-48) * error; }

/// The same for points within 2^-52 of values of size at most 2.
struct WidePlane {
  double normal;        ///< of a component of the normal
  double slope, floor;  ///< of the product with a step from p, or with p itself: slope * length + floor
};
inline WidePlane wide_plane(double u, double v) {
  constexpr double d = 0x1p-50;
  const double normal = 4 * (d * (u + v) + d * d + 2 * unit * u * v), size = 2.1 * u * v;
  return {normal, 4 * normal + 12 * unit * size, 4 * d * (normal + size)};
}

}  // namespace fathom::kernels::error_bound
