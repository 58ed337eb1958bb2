// SPDX-License-Identifier: GPL-3.0-or-later
// Results for people: a block for a single case, a line for a case of a stream. For programs there is --json.
#pragma once

#include <string>
#include <vector>

#include "cli/args/request.hpp"
#include "cli/output/answer.hpp"
#include "cli/output/text_rows.hpp"

namespace fathom::cli {

/// Several lines, without the last newline.
std::string text_block(const Answer& answer, const Request& request);

/// One line, without its newline.
std::string text_line(const Answer& answer, const Request& request);

/// Returns the id, or as a JSON string if it holds control characters.
std::string safe_id(const std::string& id);

/// Appends what the run did, stage by stage.
void add_counters(std::vector<Row>& rows, const Counters& counters);

}  // namespace fathom::cli
