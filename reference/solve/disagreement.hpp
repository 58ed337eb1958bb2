// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two answers about the same bodies, found by two methods.
// Output  where they differ.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fathom/depth.hpp"

namespace fathom::solve {

/// Returns the first field in which the answers differ, with both values, as "optima[0].direction:
/// (1, 0, 0) and (0, 1, 0)"; nullopt if they agree. Compared is every field that must not depend on
/// the method: all but `inner`, `method`, the numbers of extreme points and the counters.
std::optional<std::string> disagreement(const Depth& x, const Depth& y);

/// Returns the method of that name which can answer beside automatic, to compare with: exact or
/// naive; nullopt for other words.
std::optional<Method> second_method(std::string_view word);

}  // namespace fathom::solve
