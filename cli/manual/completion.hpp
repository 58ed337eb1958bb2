// SPDX-License-Identifier: GPL-3.0-or-later
// Completion of commands, options and their values in shells.
#pragma once

#include <span>
#include <string>

#include "cli/args/help_page.hpp"

namespace fathom::cli {

/// Returns a script for the shell, made of all pages: that of fathom first, each command's before those of its tasks. Without the last
/// newline.
std::string bash_completion(std::span<const HelpPage> pages);
std::string zsh_completion(std::span<const HelpPage> pages);
std::string fish_completion(std::span<const HelpPage> pages);

}  // namespace fathom::cli
