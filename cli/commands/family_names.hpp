// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the families, and those that a misspelt one may mean.
#pragma once

#include <string_view>
#include <vector>

namespace fathom::cli {

/// The names of all families: of polytopes, then of shapes, then of unions.
std::vector<std::string_view> family_names();

/// A few of these names. Those that hold `name` come first, then those by the fewest slips.
std::vector<std::string_view> nearest_families(std::string_view name,
                                               std::vector<std::string_view> names = family_names());

}  // namespace fathom::cli
