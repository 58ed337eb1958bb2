// SPDX-License-Identifier: GPL-3.0-or-later
// fathom metric --ball Q A B | CASES.jsonl | -
#include "cli/commands/command.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/output/hull_note.hpp"
#include "cli/output/metric_output.hpp"
#include "reference/files/mesh.hpp"

namespace fathom::cli {
namespace {

UnitBall ball_of(const Request& request) {
  try {
    return unit_ball(read_mesh(request.ball, request.decimals).points);
  } catch (const NoUnitBall& error) {
    throw InputError(request.ball, 0, error.what());
  }
}

MetricResult depth_of(const Case& pair, const UnitBall& ball, Progress& progress) {
  const ReportProgress report = [&](const std::string& stage, double share) { return progress.report(stage, share); };
  MetricResult result = metric_depth(pair.a.points, pair.b.points, ball, report);
  progress.answered();
  return result;
}

ExitCode metric_stream(const Request& request, const UnitBall& ball) {
  StreamWork work;
  work.answer = [&](const Case& pair, Progress& progress) {
    const MetricResult result = depth_of(pair, ball, progress);
    print(request.json ? metric_json(pair.id, result, ball) : metric_line(pair.id, result, ball));
  };
  if (request.json) {
    work.error_line = [](const CaseItem& item, const std::string& fault) { return metric_json_error(item.id, item.line, fault); };
  }
  return for_each_case(request.inputs[0], work);
}

}  // namespace

ExitCode run_metric(const Request& request) {
  const UnitBall ball = ball_of(request);
  if (request.inputs.size() == 1) return metric_stream(request, ball);
  const std::string &a = request.inputs[0], &b = request.inputs[1];
  const Case pair{a + " " + b, read_mesh(a, request.decimals), read_mesh(b, request.decimals)};
  const Working working;
  Progress progress;
  const MetricResult result = depth_of(pair, ball, progress);
  tell_of_hulls(pair, false, progress);
  print(request.json ? metric_json(pair.id, result, ball) : metric_block(result, ball));
  return fine;
}

}  // namespace fathom::cli
