// SPDX-License-Identifier: GPL-3.0-or-later
// What the program fathom-depth runs: `depth`. It takes half the time of fathom to build, so
// ./fathom builds it for the first answer.
#include "cli/commands/command.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {
namespace {

ExitCode refused(std::string_view name) {
  talk("fathom-depth answers depth alone; " + std::string(name) + " is a command of the program fathom");
  return bad_input;
}

}  // namespace

ExitCode run_command(const Request& request) {
  return request.command == Command::depth ? run_depth(request) : refused("this");
}

ExitCode run_command(std::string_view name, const std::vector<std::string>&) { return refused(name); }

}  // namespace fathom::cli
