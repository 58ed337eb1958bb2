// SPDX-License-Identifier: GPL-3.0-or-later
// Rounding of given numbers to the formats of records, ties to even.
#pragma once

#include <cmath>

#include "fathom/numbers.hpp"
#include "verify/golden/records/recipe.hpp"

namespace fathom::golden {

/// The nearest number of the format, which is not `given`; infinite if that overflows.
inline double nearest(const mpq_class& value, Form format) {
  return format == Form::binary32 ? double{round_binary32(value)} : round_binary64(value);
}

/// Whether the value is a number of the format.
inline bool is_in(const mpq_class& value, Form format) {
  const double closest = nearest(value, format);
  return std::isfinite(closest) && exact_value(closest) == value;
}

/// Rounds the value. Returns false, and leaves it, if it overflows.
inline bool round_to_nearest(mpq_class& value, Form format) {
  const double closest = nearest(value, format);
  if (std::isfinite(closest)) value = exact_value(closest);
  return std::isfinite(closest);
}

}  // namespace fathom::golden
