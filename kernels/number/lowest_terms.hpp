// SPDX-License-Identifier: GPL-3.0-or-later
// All exact arithmetic relies on lowest terms, which the public functions check: GMP computes wrongly with mpq_class(2, -4).
#pragma once

#include <gmpxx.h>

namespace fathom::kernels {

/// Returns whether the number is in lowest terms over a positive denominator, as mpq_class::canonicalize leaves it.
bool in_lowest_terms(const mpq_class& value);

/// Throws std::invalid_argument unless it is.
void require_lowest_terms(const mpq_class& value);

}  // namespace fathom::kernels
