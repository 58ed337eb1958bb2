// SPDX-License-Identifier: GPL-3.0-or-later
// Words quoted for /bin/sh.
#pragma once

#include <span>
#include <string>

namespace fathom::cli {

/// Returns the word in single quotes, with those inside escaped.
std::string quoted(const std::string& word);

/// Returns the words with spaces between them, quoted where needed.
std::string shell_line(std::span<const std::string> words);

/// Returns "fathom" and the words behind the program's name, quoted where needed.
std::string command_line(int argc, const char* const* argv);

}  // namespace fathom::cli
