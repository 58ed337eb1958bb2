// SPDX-License-Identifier: GPL-3.0-or-later
// fathom metric --ball Q A B | CASES.jsonl | -
#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/output/metric_output.hpp"
#include "fathom/approximate.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {
namespace {

UnitBall ball_of(const Request& request) {
  try {
    return unit_ball(read_mesh(request.ball, request.decimals).points);
  } catch (const NoUnitBall& error) {
    throw InputError(request.ball, 0, error.what());
  }
}

}  // namespace

ExitCode run_metric(const Request& request) {
  const UnitBall ball = ball_of(request);
  Replies replies;
  replies.refuses_shapes = "depth answers about those, in Euclid's norm";
  replies.reply = [&](const Case& pair, Monitor& monitor, Workspace&) -> CaseReply {
    const MetricResult result = metric_depth(pair.a.points, pair.b.points, ball, &monitor);
    if (request.json) return {metric_json(pair.id, result, ball)};
    return {is_stream(request) ? metric_line(pair.id, result, ball, request) : metric_block(result, ball, request)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) { return metric_json_error(item.id, item.line, fault); };
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
