// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the words behind `fathom certify diff` into a request, into help, or into a sentence on what is wrong with them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/args/help_page.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {

struct DiffRequest {
  std::vector<std::string> reports;  ///< the old one and the new one
  bool json = false;
  std::string html;          ///< a path; empty: not wanted
  std::string command_line;  ///< quoted for a shell
};

/// Like Arguments of the other commands.
struct DiffArguments {
  std::optional<DiffRequest> request;
  std::string text;
  ExitCode code = fine;
};

HelpPage diff_page_of_help();

/// Never throws, whatever the user typed.
DiffArguments parse_diff(const std::vector<std::string>& words);

}  // namespace fathom::cli
