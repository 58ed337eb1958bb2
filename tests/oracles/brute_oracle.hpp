// SPDX-License-Identifier: GPL-3.0-or-later
// The simplest oracle: the support function of P in every direction that could be a facet normal.
// No hull, no other library.
#pragma once

#include "tests/oracles/oracle.hpp"

namespace fathom::oracles {

/// Bodies of any rank, with duplicates and all. About (m^2 + n^2)^2 / 8 directions of m + n
/// products each: up to about 12 x 12 points.
OracleAnswer brute_oracle(std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::oracles
