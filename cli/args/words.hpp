// SPDX-License-Identifier: GPL-3.0-or-later
// What a misspelt word may be meant to be.
#pragma once

#include <span>
#include <string>

namespace fathom::cli {

/// Returns "; did you mean 'word'?" for the one of `words` that alone begins with `typed`, or else
/// is nearest to it and near; or "".
std::string did_you_mean(const std::string& typed, std::span<const std::string> words);

// Words quoted for /bin/sh.

/// Returns the word in single quotes, with those inside escaped.
std::string quoted(const std::string& word);

/// Returns the words with spaces between them, quoted where needed.
std::string shell_line(std::span<const std::string> words);

/// Returns "fathom" and the words behind the program's name, quoted where needed.
std::string command_line(int argc, const char* const* argv);

}  // namespace fathom::cli
