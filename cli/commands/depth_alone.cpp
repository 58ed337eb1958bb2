// SPDX-License-Identifier: GPL-3.0-or-later
// The command of the program fathom-depth: `depth` alone. This program builds in half the time of
// fathom, so ./fathom builds it for the first answer.
#include "cli/commands/command.hpp"

namespace fathom::cli {

ExitCode run_command(const Given& given) {
  if (given.command == "depth") return run_depth(given);
  return failed("fathom-depth answers depth alone; " + given.command + " is a command of the program fathom",
                bad_input);
}

std::string part_needed(const Given&) { return ""; }

}  // namespace fathom::cli
