// SPDX-License-Identifier: GPL-3.0-or-later
// Depths within a factor for people, and for programs (JSON, schemas/result.schema.json).
#pragma once

#include <string>

#include "cli/args/request.hpp"
#include "fathom/approximate.hpp"
#include "reference/output/json_values.hpp"

namespace fathom::cli {

/// Several lines, or one; without the last newline.
std::string approx_block(const ApproxDepth& depth, const output::AboutBodies& bodies, const Request& request);
std::string approx_line(const std::string& id, const ApproxDepth& depth, const Request& request);

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string approx_json(const std::string& id, const ApproxDepth& depth, const output::AboutBodies& bodies, const Request& request);

}  // namespace fathom::cli
