// SPDX-License-Identifier: GPL-3.0-or-later
// What all exact arithmetic relies on, asked at the doors: mpq_class(2, -4) is a number that GMP computes wrongly with.
#pragma once

#include <gmpxx.h>

namespace fathom {

/// Whether the number is in lowest terms over a positive denominator, as mpq_class::canonicalize leaves it.
bool in_lowest_terms(const mpq_class& value);

/// Throws std::invalid_argument unless it is.
void require_lowest_terms(const mpq_class& value);

}  // namespace fathom
