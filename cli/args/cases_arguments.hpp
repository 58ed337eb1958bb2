// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fathom cases`, and which of them go together.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/args/request.hpp"

namespace fathom::cli {

/// Adds all options but --exact-decimals and the two meshes.
void add_cases_options(CLI::App& app, CasesRequest& cases);

/// Returns what contradicts itself in the parsed options of `app`, or "". Sets `cases.what`.
std::string wrong_cases(const CLI::App& app, CasesRequest& cases, const std::vector<std::string>& inputs);

}  // namespace fathom::cli
