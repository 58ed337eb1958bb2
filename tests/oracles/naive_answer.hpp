// SPDX-License-Identifier: GPL-3.0-or-later
// The project's own naive twin in the oracles' words, so that it can be compared with them.
#pragma once

#include "reference/depth/penetration_depth.hpp"
#include "reference/polytope/lattice.hpp"
#include "tests/oracles/oracle.hpp"

namespace fathom::oracles {

inline OracleAnswer naive_answer(std::span<const Point> a, std::span<const Point> b) {
  const polytope::PlacedPair placed = polytope::place(a, b);
  const depth::NaiveDepth naive = depth::naive_depth(placed.a.points(), placed.b.points());
  return {naive.status, mpq_class(naive.squared / (placed.denominator * placed.denominator)), naive.directions};
}

}  // namespace fathom::oracles
