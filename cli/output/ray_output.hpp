// SPDX-License-Identifier: GPL-3.0-or-later
// Directional depths for people, and for programs (JSON, schemas/ray.schema.json).
#pragma once

#include <cstddef>
#include <string>

#include "cli/args/request.hpp"
#include "fathom/approximate.hpp"

namespace fathom::cli {

/// Several lines, or one; without the last newline.
std::string ray_block(const DirectionalDepth& depth, const Request& request);
std::string ray_line(const std::string& id, const DirectionalDepth& depth, const Request& request);

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string ray_json(const std::string& id, const DirectionalDepth& depth, const Request& request);
/// Returns the line for a case of a stream that has no result.
std::string ray_json_error(const std::string& id, std::size_t line, const std::string& error);

}  // namespace fathom::cli
