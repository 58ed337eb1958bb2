// SPDX-License-Identifier: GPL-3.0-or-later
// fathom ray --direction X,Y,Z A B | CASES.jsonl | -
#include "cli/commands/command.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/output/hull_note.hpp"
#include "cli/output/ray_output.hpp"
#include "reference/files/mesh.hpp"

namespace fathom::cli {
namespace {

DirectionalDepth depth_of(const Case& pair, const Request& request, Progress& progress) {
  const ReportProgress report = [&](const std::string& stage, double share) { return progress.report(stage, share); };
  DirectionalDepth result = directional_depth(pair.a.points, pair.b.points, *request.direction, report);
  progress.answered();
  return result;
}

ExitCode ray_stream(const Request& request) {
  StreamWork work;
  work.answer = [&](const Case& pair, Progress& progress) {
    const DirectionalDepth depth = depth_of(pair, request, progress);
    print(request.json ? ray_json(pair.id, depth, request) : ray_line(pair.id, depth));
  };
  if (request.json)
    work.error_line = [](const CaseItem& item, const std::string& fault) { return ray_json_error(item.id, item.line, fault); };
  return for_each_case(request.inputs[0], work);
}

}  // namespace

ExitCode run_ray(const Request& request) {
  if (request.inputs.size() == 1) return ray_stream(request);
  const std::string &a = request.inputs[0], &b = request.inputs[1];
  const Case pair{a + " " + b, read_mesh(a, request.decimals), read_mesh(b, request.decimals)};
  const Working working;
  Progress progress;
  const DirectionalDepth depth = depth_of(pair, request, progress);
  tell_of_hulls(pair, false, progress);
  print(request.json ? ray_json(pair.id, depth, request) : ray_block(depth, request));
  return fine;
}

}  // namespace fathom::cli
