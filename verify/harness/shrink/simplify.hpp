// SPDX-License-Identifier: GPL-3.0-or-later
// Simpler numbers near a number. Not a door.
#pragma once

#include <gmpxx.h>

#include <vector>

namespace fathom::harness {

/// The integer nearest to `value`; halves go up.
mpz_class nearest_integer(const mpq_class& value);

/// `value` to the nearest multiple of 2^exponent.
mpq_class to_multiple(const mpq_class& value, long exponent);

/// Rounds `value`, a binary fraction, to the nearest number with that many significant bits, at least 1.
mpq_class to_bits(const mpq_class& value, long bits);

/// Simpler numbers to try in place of `value`, the simplest first; each costs less than `value`, or the same without its sign.
std::vector<mpq_class> simpler(const mpq_class& value);

}  // namespace fathom::harness
