// SPDX-License-Identifier: GPL-3.0-or-later
// Runs programs that are built beside this one, in its place or as children.
#pragma once

#include <string>
#include <vector>

namespace fathom::cli {

/// Replaces this process by `program`, found beside this one or else on PATH, with these arguments. Returns only if it is not found.
void become(const std::string& program, std::vector<std::string> words);

/// Puts this program's folder first on PATH, for children.
void look_here_first();

}  // namespace fathom::cli
