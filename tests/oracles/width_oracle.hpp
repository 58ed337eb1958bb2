// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL::Width_3: rotating calipers on the hull of one body. width(A) = depth(A, A).
//                                                                          [AGHRS, Proposition 2.1]
#pragma once

#include "tests/oracles/oracle.hpp"

namespace fathom::oracles {

/// What depth(body, body) must be. The body must have rank 3.
OracleAnswer width_oracle(std::span<const Point> body);

}  // namespace fathom::oracles
