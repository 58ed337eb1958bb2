// SPDX-License-Identifier: GPL-3.0-or-later
// The exact values of floating-point numbers.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <stdexcept>

#include "kernels/number/wide_float.hpp"

namespace fathom::testing {

inline mpq_class exactly(double x) { return mpq_class(x); }

/// Digit by digit: what is left after the first 53 bits is again a number. Of size at most 2^300.
inline mpq_class exactly(const kernels::WideFloat& x) {
  constexpr double power = 0x1p500;  // powers of two are exact factors
  mpq_class sum;
  for (kernels::WideFloat rest = x * power; rest.sign() != 0;) {
    const double leading = rest.truncated();
    if (leading == 0 || !std::isfinite(leading)) throw std::domain_error("beyond binary64");
    sum += mpq_class(leading);
    rest = rest - kernels::WideFloat(leading);
  }
  return sum / mpq_class(power);
}

}  // namespace fathom::testing
