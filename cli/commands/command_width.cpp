// SPDX-License-Identifier: GPL-3.0-or-later
// fathom width [--delta D] A | CASES.jsonl | -
#include "cli/commands/approximate_replies.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"

namespace fathom::cli {

ExitCode run_width(const Request& request) {
  return reply_to_inputs(request, request.delta ? approximate_replies(request) : exact_replies(request));
}

}  // namespace fathom::cli
