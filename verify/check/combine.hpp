// SPDX-License-Identifier: Apache-2.0
// What a few half-spaces say together: the multipliers of a leaf.           [FORMAT.md, section 12]
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "vectors.hpp"

namespace fathom_check {

/// The x with <n,x> >= c.
struct Constraint {
  MutableVector n;
  mpz_class c;
};

constexpr std::size_t most_constraints = 4;

/// The sum of multiples >= 0 of the constraints, at most four, that the adjugate of their Gram
/// matrix yields. Returns nullopt if it yields none, or a negative multiplier. Positive multiples
/// of the constraints yield a positive multiple of the same.
std::optional<Constraint> combined(const std::vector<Constraint>& constraints);

}  // namespace fathom_check
