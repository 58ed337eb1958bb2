// SPDX-License-Identifier: GPL-3.0-or-later
// fathom depth A B | CASES.jsonl | -
#include "cli/commands/answer.hpp"
#include "cli/commands/command.hpp"
#include "reference/approximate/shallow.hpp"
#include "reference/files/mesh.hpp"

namespace fathom::cli {

ExitCode run_depth(const Request& request) {
  const Solve solve = [](const Case& pair, const Options& options) {
    if (options.method == Method::shallow) return shallow_depth(pair.a.points, pair.b.points, options);
    return penetration_depth(pair.a.points, pair.b.points, options);
  };
  const Answering answering = answer_by(request, solve);
  if (request.inputs.size() == 1) return answer_stream(request, answering);
  const std::string &a = request.inputs[0], &b = request.inputs[1];
  return answer_single(request, {a + " " + b, read_mesh(a, request.decimals), read_mesh(b, request.decimals)}, answering);
}

}  // namespace fathom::cli
