// SPDX-License-Identifier: GPL-3.0-or-later
// Cosines and sines, correctly rounded.                                                                             [proofs/number.md]
#pragma once

#include <gmpxx.h>

namespace fathom::kernels {

enum class AngleUnit { degrees, radians };

struct CosineAndSine {
  mpq_class cosine, sine;
};

/// Returns the cosine and the sine of the angle, each rounded to the nearest number of 53 bits, whatever its exponent. They are exact where
/// they can be: at multiples of 30 degrees.
CosineAndSine cosine_and_sine(const mpq_class& angle, AngleUnit unit);

}  // namespace fathom::kernels
