// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `fathom certify`, and which of them go together.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/args/request.hpp"

namespace fathom::cli {

/// Adds all options but the stream of cases.
void add_certify_options(CLI::App& app, Request& request);

/// Returns what is missing or contradicts itself, the inputs included, or "". Sets `variants`.
std::string wrong_certify(CertifyRequest& certify, const std::vector<std::string>& inputs);

}  // namespace fathom::cli
