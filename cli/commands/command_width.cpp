// SPDX-License-Identifier: GPL-3.0-or-later
// fathom width [--delta D] A | CASES.jsonl | -
#include "cli/commands/answer.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/command_approx.hpp"
#include "fathom/width.hpp"
#include "reference/approximate/shallow.hpp"
#include "reference/files/mesh.hpp"
#include "reference/files/source.hpp"

namespace fathom::cli {
namespace {

/// A single argument may be a mesh or a stream; its name tells.
bool names_stream(const std::string& path) {
  const std::string kind = extension(path);
  return path == "-" || kind == "jsonl" || kind == "ndjson" || kind == "json";
}

}  // namespace

ExitCode run_width(const Request& request) {
  const Solve solve = [](const Case& body, const Options& options) {
    if (options.method == Method::shallow) return shallow_depth(body.a.points, body.a.points, options);
    return width(body.a.points, options);
  };
  const std::string& input = request.inputs[0];
  const Answering answering = request.delta ? approximating(request) : answer_by(request, solve);
  if (names_stream(input)) return answer_stream(request, answering);
  return answer_single(request, {input, read_mesh(input, request.decimals), {}}, answering);
}

}  // namespace fathom::cli
