// SPDX-License-Identifier: GPL-3.0-or-later
// The exact values of floating-point numbers.
#pragma once

#include <gmpxx.h>

#include <cmath>

#include "kernels/number/wide_float.hpp"

namespace fathom::testing {

inline mpq_class exactly(double x) { return mpq_class(x); }

/// Digit by digit: what is left after the first 53 bits is again a number. Powers of two are exact
/// factors.
inline mpq_class exactly(const kernels::WideFloat& x) {
  kernels::WideFloat rest = x;
  mpq_class unit = 1, sum;
  for (; !std::isfinite(rest.truncated()); rest = rest * 0x1p-500) unit *= mpq_class(0x1p500);
  for (; rest.sign() != 0 && std::fabs(rest.truncated()) < 0x1p-400; rest = rest * 0x1p500) unit /= mpq_class(0x1p500);
  while (rest.sign() != 0) {
    const double leading = rest.truncated();
    sum += mpq_class(leading);
    rest = rest - kernels::WideFloat(leading);
  }
  return sum * unit;
}

}  // namespace fathom::testing
