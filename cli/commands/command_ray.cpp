// SPDX-License-Identifier: GPL-3.0-or-later
// fathom ray --direction X,Y,Z A B | CASES.jsonl | -
#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/output/ray_output.hpp"
#include "fathom/approximate.hpp"

namespace fathom::cli {

ExitCode run_ray(const Request& request) {
  Replies replies;
  replies.refuses_shapes = "how far it must move in one direction is not answered about those; depth says how far in the best one";
  replies.reply = [&request](const Case& pair, Monitor& monitor, Workspace&) -> CaseReply {
    const DirectionalDepth depth = directional_depth(pair.a.points, pair.b.points, *request.direction, &monitor);
    if (request.json) return {ray_json(pair.id, depth, request)};
    return {is_stream(request) ? ray_line(pair.id, depth, request) : ray_block(depth, request)};
  };
  if (request.json)
    replies.error_line = [](const CaseItem& item, const std::string& fault) { return ray_json_error(item.id, item.line, fault); };
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
