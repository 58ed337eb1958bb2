// SPDX-License-Identifier: Apache-2.0
// The checks of FORMAT.md, section 4. Each returns if all is proved and throws a Fault otherwise.
#pragma once

#include "certificate.hpp"
#include "scaled.hpp"

namespace fathom_check {

/// A bound of h(n)/|n|, squared with its sign, in the units of the scaled points, in lowest terms.
struct Bound {
  mpz_class num, den;
};

/// The whole of section 4: the claim of `certificate` is proved by its parts.
void check_claim(const Certificate& certificate);

/// The upper side (section 5): each direction's height compared as the claim demands. If a core is a half-space, the lower side too.
void check_directions(const Certificate& certificate, const Scaled& bodies, const Bound& low, const Bound& high);

/// The weights are convex, and yield points of A and of B that are so near to each other that h(n)/|n| is at least `low`.
void check_weights(const Certificate& certificate, const Scaled& bodies, const Bound& low);

/// The inner polytope holds a ball of squared radius `squared` around O; with `all`, no direction is missing.
void check_inner(const Certificate& certificate, const Scaled& bodies, const Bound& squared);

/// No vector has h = 0 but those of the cone.
void check_cone(const Certificate& certificate, const Scaled& bodies);

}  // namespace fathom_check
