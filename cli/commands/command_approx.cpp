// SPDX-License-Identifier: GPL-3.0-or-later
// fathom approx --delta D A B | CASES.jsonl | -
#include "cli/commands/approximate_replies.hpp"
#include "cli/commands/command.hpp"

namespace fathom::cli {

ExitCode run_approx(const Request& request) { return reply_to_inputs(request, approximate_replies(request)); }

}  // namespace fathom::cli
