// SPDX-License-Identifier: GPL-3.0-or-later
// Results for people: a block for a single case, a line for a case of a stream. For programs there is --json.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/answer.hpp"
#include "cli/request.hpp"

namespace fathom::cli {

/// Several lines, without the last newline.
std::string text_block(const Answer& answer, const Request& request);

/// One line, without its newline.
std::string text_line(const Answer& answer, const Request& request);

/// The id as it is, unless it would break the line or play tricks with a terminal.
std::string safe_id(const std::string& id);

/// "A: 3 of 11 points are not extreme; the convex hull is taken", for each body of which that is known and true; else nothing.
std::optional<std::string> hull_note(const Answer& answer, const Request& request);

/// The same for a pair and the numbers of its extreme points; 0: not known.
std::optional<std::string> hull_note(const Case& pair, std::uint32_t extreme_a, std::uint32_t extreme_b);

}  // namespace fathom::cli
