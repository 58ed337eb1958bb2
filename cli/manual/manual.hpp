// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of the pages of help: completion in shells, and manual pages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/help_page.hpp"

namespace fathom::cli {

/// Returns a script for the shell, made of all pages: that of fathom first, each command's before
/// those of its tasks. Without the last newline.
std::string bash_completion(std::span<const HelpPage> pages);
std::string zsh_completion(std::span<const HelpPage> pages);
std::string fish_completion(std::span<const HelpPage> pages);

inline constexpr const char* shells[] = {"bash", "zsh", "fish"};

/// Whether it is a task of another command: "golden verify".
inline bool is_task(const CommandHelp& command) { return command.name.find(' ') != command.name.npos; }

/// "fathom", "fathom-depth".
std::string man_name(const CommandHelp& command);

/// Returns the page as roff with the macros of man, and behind it those of the command's tasks.
/// `others`: the pages to refer to. Without the last newline.
std::string man_page(const HelpPage& page, std::span<const HelpPage> tasks, std::span<const std::string> others);

}  // namespace fathom::cli
