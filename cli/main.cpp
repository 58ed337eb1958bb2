// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of `fathom`, and of `fathom-depth`: parses the arguments, runs the command, and
// turns errors into one sentence and an exit code.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "cli/io/progress.hpp"
#include "kernels/float_environment.hpp"

namespace {

using namespace fathom::cli;

constexpr const char* mpi_program = "fathom-mpi";

/// Returns whether an MPI launcher started several processes, which share this command.
bool is_shared_by_many(const std::vector<std::string>& words) {
  const char* const size = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (size == nullptr || std::atoi(size) < 2 || words.empty()) return false;
  return words[0] == "golden" || words[0] == "certify" || words[0] == "depth";
}

ExitCode become_mpi(const std::vector<std::string>& words) {
  become(mpi_program, words);
  return failed(
      std::string(mpi_program) +
          " is not here: it is built where CMake finds Open MPI and Boost.MPI (Debian: libboost-mpi-dev, openmpi-bin)",
      bad_input);
}

/// Prints the name of the part that the command line needs, or nothing. Called by ./fathom, which
/// builds a part that needs further packages when it is first used.
ExitCode tell_part(const std::vector<std::string>& words) {
  if (is_shared_by_many(words)) print("mpi");
  else if (const Arguments arguments = parse_arguments(words); arguments.given) {
    if (const std::string part = part_needed(*arguments.given); !part.empty()) print(part);
  }
  return fine;
}

ExitCode run(const std::vector<std::string>& words) {
  if (!words.empty() && words[0] == "--part") return tell_part({words.begin() + 1, words.end()});
  if (is_shared_by_many(words)) return become_mpi(words);
  const Arguments arguments = parse_arguments(words);
  return arguments.given ? run_command(*arguments.given) : said(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  guard_memory();
  const fathom::kernels::DefaultFloatEnvironment
      environment;  // a shared library may have changed it; threads inherit it
  hold_standard_streams();
  install_signal_handlers();
  return guarded([&] { return run({argv + std::min(argc, 1), argv + argc}); });
}
