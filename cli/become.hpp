// SPDX-License-Identifier: GPL-3.0-or-later
// Hands the process over to a program that is built beside this one.
#pragma once

#include <string>
#include <vector>

namespace fathom::cli {

/// Becomes `program`, beside this one or else on the path, with these words behind its name. Returns only if there is none.
void become(const std::string& program, std::vector<std::string> words);

}  // namespace fathom::cli
