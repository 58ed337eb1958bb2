// SPDX-License-Identifier: GPL-3.0-or-later
// Words as /bin/sh takes them.
#pragma once

#include <string>

namespace fathom::cli {

/// In single quotes, those inside taken care of.
std::string quoted(const std::string& word);

/// "fathom" and the words behind the program's name, each between quotes where it must be.
std::string command_line(int argc, const char* const* argv);

}  // namespace fathom::cli
