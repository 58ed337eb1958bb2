// SPDX-License-Identifier: GPL-3.0-or-later
// Error bounds of the floating-point filters on lines, absolute, for images within 2^-53 of values of size at most 1. They hold in every
// rounding mode, and are derived in proofs/closest_lines.md.
#pragma once

namespace fathom::line_error {

inline constexpr double unit = 0x1p-52;
inline constexpr double height = 96 * unit;           ///< of <p - q, d x e>
inline constexpr double squared_length = 112 * unit;  ///< of |d x e|^2
inline constexpr double side = 16 * unit;             ///< of <n, d>

}  // namespace fathom::line_error
