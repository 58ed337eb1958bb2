// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `depth --along`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/args/request.hpp"

namespace fathom::cli {

void add_along_options(CLI::App& app, Request& request);

/// Returns what does not go together, or "". `depth`: the command as it was parsed.
std::string wrong_along(const CLI::App& depth, const Request& request);

}  // namespace fathom::cli
