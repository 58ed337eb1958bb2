// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tiers meet: doubles with a proved bound on the error, then intervals; exact integers when the interval holds zero;
// infinitesimals only when the exact sign is zero.                                                                  [proofs/kernels.md]
#pragma once

#include "kernels/counters.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/predicates/predicates.hpp"

namespace fathom {

/// The exact sign of each predicate of predicates.hpp on the input itself: -1, 0 or 1.
int side_of_equator(const Direction& n, const Direction& z);
int x_order(const Direction& n1, const Direction& n2, const Direction& v);
int side_of_arc(const Direction& n, const Direction& d);
int order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n, const Direction& v);
int order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z);

/// The signs of the perturbed operands, -1 or 1: never zero. Where the exact sign is not zero it is the answer. Throws std::logic_error
/// when the operands are related in a way that no perturbation resolves (a node on a circle of its own body, parallel circles of one
/// body): such questions are answered combinatorially and must not be asked.                   [proofs/perturbation.md]
int perturbed_side_of_equator(const Perturbation& p, const Direction& n, const Direction& z);
int perturbed_x_order(const Perturbation& p, const Direction& n1, const Direction& n2, const Direction& v);
int perturbed_side_of_arc(const Perturbation& p, const Direction& n, const Direction& d);
int perturbed_order_on_vertical(const Perturbation& p, const Direction& d1, const Direction& d2, const Direction& n, const Direction& v);
int perturbed_order_at_infinity(const Perturbation& p, const Direction& d1, const Direction& d2, const Direction& z);

/// Counts calls that another filter has settled.
void count_calls(Predicate id, std::uint64_t calls);

/// The calls made by this thread until now: further calls show when it is read again.
PredicateCounts& predicate_counts();

}  // namespace fathom
