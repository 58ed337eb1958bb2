// SPDX-License-Identifier: GPL-3.0-or-later
// Results as JSON: one object per line, fields as in schemas/result.schema.json and in its order.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cli/args/request.hpp"
#include "cli/output/answer.hpp"

namespace fathom::cli {

/// The schema of results, exact and approximate ones.
inline constexpr const char* result_schema = "fathom/result/1";

/// One line, without its newline. Pure ASCII whatever the id holds.
std::string json_result(const Answer& answer, const Request& request);

/// Returns the line for a case of a stream that has no result.
std::string json_error(const std::string& id, std::size_t line, std::string_view error);

}  // namespace fathom::cli
