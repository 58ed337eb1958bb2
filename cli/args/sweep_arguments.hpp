// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `study --sweep`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/args/request.hpp"

namespace fathom::cli {

void add_sweep_options(CLI::App& app, Request& request);

/// Returns what does not go together, or "". `study`: the command as it was parsed. Sets the sizes if none were given.
std::string wrong_sweep(const CLI::App& study, Request& request);

}  // namespace fathom::cli
