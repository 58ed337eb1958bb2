// SPDX-License-Identifier: GPL-3.0-or-later
// The option of `depth` for bodies that are unions of convex pieces.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/args/request.hpp"

namespace fathom::cli {

void add_pieces_option(CLI::App& app, Request& request);

/// Returns what does not go together with --pieces, or "". `depth`: the command as it was parsed.
std::string wrong_pieces(const CLI::App& depth, const Request& request);

}  // namespace fathom::cli
