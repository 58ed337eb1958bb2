// SPDX-License-Identifier: Apache-2.0
// The checks of FORMAT.md, section 4. Each returns if all is proved and throws a Fault otherwise.
#pragma once

#include "certificate.hpp"
#include "scaled.hpp"

namespace fathom_check {

/// A bound of depth^2 in the units of the scaled points, in lowest terms.
struct Bound {
  mpz_class num, den;
};

/// The whole of section 4: the claim of `certificate` is proved by its parts.
void check_claim(const Certificate& certificate);

/// Directions (section 5, upper side): each h(n) compared as the claim demands.
void check_directions(const Certificate& certificate, const Scaled& bodies, const Bound& squared);

/// The weights are convex and yield the same point of A and of B.
void check_weights(const Certificate& certificate, const Scaled& bodies);

/// The inner polytope holds a ball of squared radius `squared` around O; with `all`, no direction is missing.
void check_inner(const Certificate& certificate, const Scaled& bodies, const Bound& squared);

}  // namespace fathom_check
