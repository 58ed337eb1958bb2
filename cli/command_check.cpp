// SPDX-License-Identifier: GPL-3.0-or-later
// fathom check [--proved] CERTIFICATES...   hands over to the independent checkers, which have a parser and a command line of their own.
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "cli/become.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "verify/check/command_line.hpp"

namespace fathom::cli {
namespace {

constexpr const char* proved_program = "fathom-check-proved";

/// Becomes the checker that was extracted from the Coq development; returns only if there is none, beside this program or on the path.
ExitCode become_proved(const std::vector<std::string>& words) {
  become(proved_program, words);
  talk(std::string(proved_program) +
       " is not here: it is built from proofs/coq, with Coq and OCaml (Debian: coq, libzarith-ocaml-dev, ocaml-findlib)");
  return internal_error;
}

}  // namespace

ExitCode run_check(std::vector<std::string> words) {
  const auto files = std::find(words.begin(), words.end(), "--");
  const auto proved = std::find(words.begin(), files, "--proved");
  if (proved == files) {
    const int code = fathom_check::command_line(words, "fathom check");
    return std::cout ? static_cast<ExitCode>(code) : internal_error;  // a program of its own has no such code: fathom-check says 2
  }
  words.erase(proved);
  return become_proved(words);
}

}  // namespace fathom::cli
