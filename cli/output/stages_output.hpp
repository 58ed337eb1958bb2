// SPDX-License-Identifier: GPL-3.0-or-later
// Stages for people: how large each was, and what came of it. For programs there is stages::to_json.
#pragma once

#include <string>

#include "view/stages/stages.hpp"

namespace fathom::cli {

/// Several lines, without the last newline.
std::string stages_block(const stages::Stages& stages);

/// One line, without its newline.
std::string stages_line(const stages::Stages& stages);

}  // namespace fathom::cli
