// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the command line into a request, into help, or into a sentence on what is wrong with it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/args/help_page.hpp"
#include "cli/args/request.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {

/// Either a request, or a text for the user and the exit code that goes with it: help and version (fine, for standard output), or a
/// refusal (bad_input, for standard error).
struct Arguments {
  std::optional<Request> request;
  std::string text;
  ExitCode code = fine;
};

/// The pages of help: of fathom, and of the commands whose arguments are parsed here.
std::vector<HelpPage> help_pages();

/// Never throws, whatever the user typed.
Arguments parse_arguments(int argc, const char* const* argv);

}  // namespace fathom::cli
