// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of all floating-point filters. They hold in every rounding mode, for images within half_ulp of values of size at most 1
// unless said otherwise.                                                                       [proofs/kernels.md, "Error bounds"]
#pragma once

namespace fathom::error_bound {

inline constexpr double unit = 0x1p-52;  ///< of one operation, relative to its result

/// Absolute, of values of images.
inline constexpr double product = 0x1p-48;            ///< of <n,d>: SideOfEquator, SideOfArc
inline constexpr double determinant = 0x1p-46;        ///< of <a x b, c>: XOrder, OrderAtInfinity
inline constexpr double order_on_vertical = 0x1p-44;  ///< of <d2,n><d1,v> - <d1,n><d2,v>, in either form

}  // namespace fathom::error_bound
