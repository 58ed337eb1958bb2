// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the request of a command from what was given, or help, or a sentence on what is wrong.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/args/given.hpp"
#include "cli/args/request.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {

/// Either a request, or a text for the user and the exit code that goes with it: help and version
/// (fine, for standard output), or a refusal (bad_input, for standard error).
struct Arguments {
  std::optional<Request> request;
  std::string text;
  ExitCode code = fine;
};

/// Never throws, whatever the user typed.
Arguments parse_arguments(int argc, const char* const* argv);

/// The methods behind --method of a command that computes its answers in two ways: each once, in
/// the order of the words.
std::vector<Method> second_methods(const Given& given);

}  // namespace fathom::cli
