// SPDX-License-Identifier: GPL-3.0-or-later
// The sampled cutting: the same answer as cutting.hpp, in the paper's own shape.           [AGHRS, section 2.2; proofs/cutting.md]
// How     a random sample of r log2(r + 1) lines of one chain guides how the other is cut into cells: a cell is halved while some line
//         of the sample may approach it. Then its whole conflict list is counted, line by line; over the quota |L|/r it is refined.
//         Roles swap, subproblems come in random order, and a naive scan ends it.
// Why     for study, and as a cross-check. It is not the sample that makes it fast, but the conflict lists, which are counted anyway.
#pragma once

#include "reference/lines/closest_lines.hpp"
#include "reference/lines/grid.hpp"
#include "reference/lines/line_search.hpp"

namespace fathom::lines {

/// As closest_by_cutting.
void closest_by_sampling(const Grid& grid, LineSearch& search, const SampledSize& size = {});

}  // namespace fathom::lines
