// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths, unit vectors and translations, correctly rounded in every mode.  [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <array>

#include "fathom/signed_depth.hpp"
#include "kernels/vector.hpp"

namespace fathom::golden {

/// A number in both formats and all modes; a binary32 value as its equal double. Modes in the order rn, rd, ru.
struct Rounded {
  std::array<double, 3> binary64, binary32;
};

using RoundedVector = std::array<Rounded, 3>;  ///< x, y, z

Rounded rounded_value(const mpq_class& value);

/// The root of `squared` >= 0.
Rounded rounded_root(const mpq_class& squared);

/// n / |n|; n is not zero. A component is the root of n_i^2 / <n,n> with the sign of n_i, so rd and ru change places for a negative one.
RoundedVector rounded_unit(const Vector& n);

RoundedVector rounded_point(const Point& p);

Rounded rounded_surd(const Surd& value);

/// alpha n + beta n/|n|, each component by itself.
RoundedVector rounded_along(const AlongNormal& vector);

}  // namespace fathom::golden
