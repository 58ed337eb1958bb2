// SPDX-License-Identifier: GPL-3.0-or-later
// fathom check [--proved] CERTIFICATES...   hands over to the independent checkers, which have a parser and a command line of their own.
#include <unistd.h>

#include <algorithm>
#include <climits>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "verify/check/command_line.hpp"

namespace fathom::cli {
namespace {

constexpr const char* proved_program = "fathom-check-proved";

/// The folder that this program lies in, with a slash; empty if the system does not tell.
std::string own_folder() {
  std::string path(PATH_MAX, '\0');
  const ssize_t length = readlink("/proc/self/exe", path.data(), path.size());
  path.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  return path.substr(0, path.rfind('/') + 1);
}

/// Becomes the checker that was extracted from the Coq development; returns only if there is none, beside this program or on the path.
ExitCode become_proved(std::vector<std::string> words) {
  words.insert(words.begin(), proved_program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string folder = own_folder();
  if (!folder.empty()) execv((folder + proved_program).c_str(), arguments.data());
  execvp(proved_program, arguments.data());
  talk(std::string(proved_program) +
       " is not here: it is built from proofs/coq, with Coq and OCaml (Debian: coq, libzarith-ocaml-dev, ocaml-findlib)");
  return internal_error;
}

}  // namespace

ExitCode run_check(std::vector<std::string> words) {
  const auto files = std::find(words.begin(), words.end(), "--");
  const auto proved = std::find(words.begin(), files, "--proved");
  if (proved == files) return static_cast<ExitCode>(fathom_check::command_line(words, "fathom check"));
  words.erase(proved);
  return become_proved(std::move(words));
}

}  // namespace fathom::cli
