// SPDX-License-Identifier: Apache-2.0
// The checks of unions, one by one.                                         [FORMAT.md, section 12]
#pragma once

#include <cstddef>
#include <vector>

#include "certificate.hpp"
#include "checks.hpp"
#include "scaled.hpp"
#include "vectors.hpp"

namespace fathom_check {

/// The points of piece `number`.
Points piece(const Body& body, const ScaledBody& scaled, std::size_t number);

/// The optima ascend, their squares are q, and each is separated from all interiors. `squared` is q
/// in the units of the scaled points.
void check_optima(const Certificate& certificate, const Scaled& bodies, const Bound& squared);

/// Every polytope is inside the differences of its pieces. Returns the planes of all facets, for
/// primitive normals, in the units of the scaled points; their digits lie in `integers`.
std::vector<Plane> check_polytopes(const Certificate& certificate, const Scaled& bodies, Arena& integers);

/// The tree leaves no place for another optimum, nor for a nearer one.
void check_tree(const Certificate& certificate, const std::vector<Plane>& facets, const Bound& squared);

}  // namespace fathom_check
