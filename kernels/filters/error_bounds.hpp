// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of the floating-point filters. They hold in every rounding mode, for images
// within 2^-53 of values of size at most 1 unless said otherwise.
//                                                               [proofs/kernels.md, "Error bounds"]
#pragma once

namespace fathom::kernels::error_bound {

inline constexpr double unit = 0x1p-52;  ///< of one operation in binary64, relative to its result
/// The same for any floating-point numbers. Bounds that are multiples of it hold for each kind of
/// numbers.
template <class Number>
inline constexpr double unit_of = Number::unit;
template <>
inline constexpr double unit_of<double> = unit;

// Absolute.

inline constexpr double product = 0x1p-48;            ///< of <n,d>
inline constexpr double determinant = 0x1p-46;        ///< of <a x b, c>
inline constexpr double order_on_vertical = 0x1p-44;  ///< of <d2,n><d1,v> - <d1,n><d2,v>, in either form
inline constexpr double rise = 0x1p-47;               ///< of <u, q - p>, for points within 2^-52
/// A direction's enclosure is made an image if it errs by less than 2^-wide_digits.
inline constexpr int wide_digits = 60;
inline constexpr double turn = 0x1p-44;  ///< of a width times a rise, less another such product
template <class Number>
inline constexpr double height_over_line_of = 96 * unit_of<Number>;  ///< of <p - q, d x e>
template <class Number>
inline constexpr double squared_length_of = 112 * unit_of<Number>;  ///< of |d x e|^2
inline constexpr double height_over_line = height_over_line_of<double>, squared_length = squared_length_of<double>;
/// of <u,p> - <u,q>, for exact u and images of rational points
inline constexpr double difference_of_heights = 0x1p-46;

// Factors that make up for the roundings of a few operations.

inline constexpr double raised_bound = 1 + 16 * unit;   ///< of a squared distance that a computed one must exceed
inline constexpr double lowered_bound = 1 - 16 * unit;  ///< of a squared distance that a computed one must stay below
/// of a quotient of numbers truncated to 53 bits: an upper bound
inline constexpr double raised_quotient = 1 + 8 * unit;
inline constexpr double below_raised = 1 - 0x1p-47;  ///< of that upper bound: a lower bound
inline constexpr double raised_root = 1 + 0x1p-40;   ///< of the root of a quotient, and of a product with it
/// more than 1: of a root, where lengths are measured in a nearly orthonormal frame
template <class Number>
inline constexpr double frame_length = 512 * unit_of<Number>;
/// absolute: of that frame's determinant, which is nearly 1
template <class Number>
inline constexpr double frame_volume = 256 * unit_of<Number>;
/// absolute: of the computed products of that frame's directions
template <class Number>
inline constexpr double orthonormal = 16 * unit_of<Number>;

// Of Taylor models, and of the parabolas that lines are fitted with.

/// of a product's coefficients together, relative to the product of the norms
template <class Number>
inline constexpr double taylor_product = 8 * unit_of<Number>;
template <class Number>
inline constexpr double taylor_sum = 4 * unit_of<Number>;  ///< of a combination's, relative to the norms
template <class Number>
inline constexpr double taylor_least = 64 * unit_of<Number>;  ///< of a minimum over the square, relative to the norm
template <class Number>
inline constexpr double parabola = 8 * unit_of<Number>;  ///< of a parabola's value, relative to the sizes of its terms
/// Of a coordinate of a line's tuple, whose point is moved along the line by t directions.
template <class Number>
inline double tuple(double t) {
  return unit_of<Number> * (16 + 32 * (t < 0 ? -t : t));
}
/// factor of a sum of fewer than 30 products, none of them negative; besides it
inline constexpr double raised_radius = 1 + 64 * unit;
inline constexpr double underflow = 0x1p-1000;  ///< what all underflow of such a sum may add up to, by far

// Of (q - p) x (r - p), and of its product with a step t - s, for points p, q, r, s, t. These
// follow the size of the triangle: u and v are the largest components of the computed edges, `size`
// that of the computed normal, `length` that of the computed step.

/// Of a component of the normal.
inline double normal(double u, double v) { return 0x1p-49 * (u + v + u * v) + 0x1p-98; }
/// Of the product, where `error` bounds that of the normal's components.
inline double height(double size, double error, double length) {
  return 0x1p-48 * size * (1 + length) + (4 * length + 0x1p-48) * error;
}

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
