// SPDX-License-Identifier: GPL-3.0-or-later
// The option of `depth` and `explain` for bodies that are unions of convex pieces.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/args/request.hpp"

namespace fathom::cli {

/// `more`: what the help says besides.
void add_pieces_option(CLI::App& app, Request& request, const std::string& more = "");

/// Returns what does not go together with --pieces, or "". `asked`: the command as it was parsed.
std::string wrong_pieces(const CLI::App& asked, const Request& request);

}  // namespace fathom::cli
