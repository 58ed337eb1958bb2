// SPDX-License-Identifier: GPL-3.0-or-later
// Where an expanding polytope starts.
#pragma once

#include <array>
#include <optional>

#include "reference/polytope/differences.hpp"

namespace fathom::expanding {

/// Returns four differences that do not lie in one plane, found in directions that lead towards O, or nullopt if P is flat. Exact.
std::optional<std::array<polytope::Difference, 4>> starting_tetrahedron(polytope::Differences& differences);

}  // namespace fathom::expanding
