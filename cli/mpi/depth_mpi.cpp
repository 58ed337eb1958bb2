// SPDX-License-Identifier: GPL-3.0-or-later
// depth on a stream: rank 0 reads the texts of the cases and prints the replies, in order; every rank reads and answers blocks of cases.
#include "cli/commands/depth.hpp"
#include "cli/commands/replies.hpp"
#include "cli/io/progress.hpp"
#include "cli/mpi/verbs.hpp"

namespace fathom::cli {

ExitCode depth_by_ranks(const Processes& world, const Request& request) {
  StreamWork work = stream_work(request, exact_replies(request));
  const Handle answer = [&](const std::string& block) { return answer_block(block, request.inputs[0], work); };
  if (world.rank() > 0) {
    follow(world, [&] { return answer; });
    return fine;
  }
  install_signal_handlers();
  Ranks ranks(world, answer);
  work.threads = ranks.count();
  work.elsewhere = [&](const std::string& block, const std::string& name) { return ranks.ask(block, name); };
  ExitCode code = internal_error;
  ranks.serve([&] { code = for_each_case(request.inputs[0], work); });
  return code;
}

}  // namespace fathom::cli
