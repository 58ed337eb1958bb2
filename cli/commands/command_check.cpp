// SPDX-License-Identifier: GPL-3.0-or-later
// fathom check [--proved] CERTIFICATES...   hands over to the independent checkers, which have a parser and a command line of their own.
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/commands/exec_program.hpp"
#include "cli/commands/proved_checker.hpp"
#include "cli/io/output.hpp"
#include "verify/check/command_line.hpp"

namespace fathom::cli {
namespace {

/// Replaces this process by the checker that was extracted from the Coq development; returns only if there is none, beside this program or
/// on the path.
ExitCode become_proved(const std::vector<std::string>& words) {
  become(proved_program, words);
  talk(proved_program_is_missing());
  return internal_error;
}

/// Compares with cases and results first, which the proved checker cannot read; then it must accept what passes.
ExitCode compare_and_prove(const std::vector<std::string>& words, bool width) {
  ProvedChecker proved(width);
  const int code = fathom_check::command_line(words, "fathom check", &proved);
  return proved.failed() || !std::cout ? internal_error : static_cast<ExitCode>(code);
}

}  // namespace

ExitCode run_check(std::vector<std::string> words) {
  const auto files = std::find(words.begin(), words.end(), "--");
  const auto proved = std::find(words.begin(), files, "--proved");
  if (proved == files) {
    const int code = fathom_check::command_line(words, "fathom check");
    return std::cout ? static_cast<ExitCode>(code) : internal_error;  // fathom-check, which has no code for internal errors, returns 2
  }
  const auto has = [&](const char* option) { return std::find(words.begin(), files, option) != files; };
  const bool compares = has("--case") || has("--results") || has("--echo") || has("--help"), width = has("--width");
  words.erase(proved);
  return compares ? compare_and_prove(words, width) : become_proved(words);
}

}  // namespace fathom::cli
