// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of `fathom`, and of `fathom-depth`: parses the arguments, runs the command, and
// turns errors into one sentence and an exit code.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "cli/args/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "cli/io/progress.hpp"
#include "kernels/float_environment.hpp"

namespace {

using namespace fathom::cli;

constexpr const char* mpi_program = "fathom-mpi";

/// Whether an MPI launcher started several processes, which share this command.
bool is_shared_by_many(int argc, char** argv) {
  const char* const size = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (size == nullptr || std::atoi(size) < 2 || argc < 2) return false;
  const std::string_view command = argv[1];
  return command == "golden" || command == "certify" || command == "depth";
}

ExitCode become_mpi(int argc, char** argv) {
  become(mpi_program, {argv + 1, argv + argc});
  return failed(
      std::string(mpi_program) +
          " is not here: it is built where CMake finds Open MPI and Boost.MPI (Debian: libboost-mpi-dev, openmpi-bin)",
      bad_input);
}

ExitCode run(int argc, char** argv) {
  if (is_shared_by_many(argc, argv)) return become_mpi(argc, argv);
  const Arguments arguments = parse_arguments({argv + std::min(argc, 1), argv + argc});
  return arguments.given ? run_command(*arguments.given) : said(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  guard_memory();
  const fathom::kernels::DefaultFloatEnvironment
      environment;  // a shared library may have changed it; threads inherit it
  hold_standard_streams();
  install_signal_handlers();
  return guarded([&] { return run(argc, argv); });
}
