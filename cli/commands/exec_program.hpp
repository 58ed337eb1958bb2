// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that are built beside this one: the process is handed over to one of them, or a child becomes it.
#pragma once

#include <string>
#include <vector>

namespace fathom::cli {

/// Becomes `program`, beside this one or else on the path, with these words behind its name. Returns only if there is none.
void become(const std::string& program, std::vector<std::string> words);

/// Puts this program's folder first on the path, for children.
void look_here_first();

}  // namespace fathom::cli
