// SPDX-License-Identifier: GPL-3.0-or-later
// Correct rounding of exact values to binary64 and binary32. Decided by integer arithmetic alone: the floating-point environment
// has no say, whatever rounding mode a filter has set.                                                    [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <string>

namespace fathom {

/// rn: to nearest, ties to even. rd: towards minus infinity. ru: towards plus infinity.
enum class Rounding { rn, rd, ru };

/// `value` correctly rounded, as IEEE 754 does: subnormals where they are due; beyond the largest finite number, infinity in the
/// direction of rounding or the largest finite number against it; rn overflows from the largest finite number plus half an ulp on.
/// A negative value that rounds to zero gives -0. The denominator must be positive; lowest terms are not needed.
double round_binary64(const mpq_class& value, Rounding mode);
float round_binary32(const mpq_class& value, Rounding mode);

/// The square root of `squared`, correctly rounded in the same sense; no root is ever taken in floating point.
/// Throws std::domain_error when `squared` is negative.
double root_binary64(const mpq_class& squared, Rounding mode);
float root_binary32(const mpq_class& squared, Rounding mode);

/// As C99 %a prints it, but in any locale: "0x1.999999999999ap-4", subnormals "0x0.0000000000001p-1022", zero "0x0p+0", "inf", "nan".
/// A float is printed through its equal double, as %a does: its subnormals look normal.
std::string hex_text(double value);

}  // namespace fathom
