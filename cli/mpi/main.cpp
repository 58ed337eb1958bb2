// SPDX-License-Identifier: GPL-3.0-or-later
// mpirun -np N fathom COMMAND ...   is replaced by this program where the processes share a command: golden generate, golden verify,
// certify, and depth on a stream. What they do not share rank 0 does alone. It is a program of its own so that fathom itself starts without
// MPI.
#include <cstdlib>
#include <string>
#include <string_view>

#include "cli/args/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/output.hpp"
#include "cli/io/process.hpp"
#include "cli/mpi/verbs.hpp"
#include "kernels/float_environment.hpp"

namespace {

using namespace fathom::cli;

ExitCode run(const Processes& world, int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "golden") return golden_by_ranks(world, {argv + 2, argv + argc});
  const Arguments arguments = parse_arguments(argc, argv);
  const bool leads = world.rank() == 0;
  if (!arguments.request) {
    if (leads) arguments.code == fine ? print(arguments.text) : talk(arguments.text);
    return arguments.code;
  }
  const Request& request = *arguments.request;
  if (request.command == Command::certify && request.certify.replay.empty() && request.certify.claims.empty() &&
      !request.certify.list_adapters)
    return certify_by_ranks(world, request);
  // Certificates go to files, one after another: rank 0 alone keeps their order.
  if (request.command == Command::depth && is_stream(request) && request.certificate.empty()) return depth_by_ranks(world, request);
  if (!leads) return fine;
  return run_command(request);
}

}  // namespace

int main(int argc, char** argv) {
  guard_memory();
  const fathom::kernels::DefaultFloatEnvironment environment;
  hold_standard_streams();
  const Processes processes(argc, argv);
  unsetenv("OMPI_COMM_WORLD_SIZE");  // programs that we start are no part of the job
  return guarded([&] { return run(processes, argc, argv); });
}
