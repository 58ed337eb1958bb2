// SPDX-License-Identifier: GPL-3.0-or-later
// How many cases a file holds, for the progress line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace fathom::cli {

/// Returns how many lines of the file begin with a brace: so many cases there are if each has a line of its own, or is indented as usual.
/// Returns nullopt if there are none, and for what can be read only once.
std::optional<std::size_t> cases_in(const std::string& path);

}  // namespace fathom::cli
