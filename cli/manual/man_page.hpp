// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of help as manual pages for man.
#pragma once

#include <span>
#include <string>

#include "cli/args/help_page.hpp"

namespace fathom::cli {

/// "fathom", "fathom-depth".
std::string man_name(const CommandHelp& command);

/// Returns the page as roff with the macros of man, and behind it those of the command's tasks. `others`: the pages to refer to. Without
/// the last newline.
std::string man_page(const HelpPage& page, std::span<const HelpPage> tasks, std::span<const std::string> others);

}  // namespace fathom::cli
