// SPDX-License-Identifier: GPL-3.0-or-later
// More about sums of a rational and square roots than fathom/numbers.hpp offers. With it the judge tells how far a claimed number is from
// a depth, which is a root.                                                                                     [proofs/number.md]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>

#include "fathom/numbers.hpp"

namespace fathom::kernels {

/// Returns the signed root of x, if it is rational.
std::optional<mpq_class> rational_root(const mpq_class& x);

/// Returns the value, if it is rational.
std::optional<mpq_class> rational_value(const Surd& value);

/// "sqrt(2) + 1/2", "-sqrt(2) + 1/2", "3/2".
std::string exact_surd_text(const Surd& value);

/// Returns the exact sign of rational + signed root of x + signed root of y.
int sign_of_sum(const mpq_class& rational, const mpq_class& x, const mpq_class& y);

/// Correctly rounded to nearest, ties to even; infinite beyond binary64. A value that rounds to zero gives +0.
double nearest_binary64(const Surd& value);

/// sqrt(value), rounded in the same way. Throws std::domain_error when the value is negative.
double nearest_root_binary64(const Surd& value);

}  // namespace fathom::kernels
