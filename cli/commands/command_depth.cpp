// SPDX-License-Identifier: GPL-3.0-or-later
// fathom depth A B | CASES.jsonl | -
#include "cli/commands/command.hpp"
#include "cli/commands/depth.hpp"

namespace fathom::cli {

ExitCode run_depth(const Request& request) {
  return request.along.translation ? run_along(request) : reply_to_inputs(request, exact_replies(request));
}

}  // namespace fathom::cli
