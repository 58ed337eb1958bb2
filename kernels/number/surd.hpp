// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of a rational and square roots: their exact sign, and their correctly rounded value. With them the judge tells how far a claimed
// number is from a depth, which is a root.  [proofs/judge.md]
#pragma once

#include <gmpxx.h>

namespace fathom::kernels {

/// rational + the signed root of `root`, where the signed root of x is sqrt(x), or -sqrt(-x) for x < 0. Both in lowest terms.
struct Surd {
  mpq_class rational, root;
};

/// Returns the exact sign, found by squaring.
int sign(const Surd& value);

/// Returns the exact sign of rational + signed root of x + signed root of y.
int sign_of_sum(const mpq_class& rational, const mpq_class& x, const mpq_class& y);

/// Correctly rounded to nearest, ties to even; infinite beyond binary64. A value that rounds to zero gives +0.
double nearest_binary64(const Surd& value);

/// sqrt(value), rounded in the same way. Throws std::domain_error when the value is negative.
double nearest_root_binary64(const Surd& value);

}  // namespace fathom::kernels
