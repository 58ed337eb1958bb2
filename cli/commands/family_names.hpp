// SPDX-License-Identifier: GPL-3.0-or-later
// The families that a misspelt name may mean.
#pragma once

#include <string_view>
#include <vector>

namespace fathom::cli {

/// A few names of families, of polytopes, of shapes and of unions. Those that hold `name` come first, then those by the fewest slips.
std::vector<std::string_view> nearest_families(std::string_view name);

}  // namespace fathom::cli
