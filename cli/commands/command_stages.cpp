// SPDX-License-Identifier: GPL-3.0-or-later
// fathom stages A B | CASES.jsonl | -
#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/output/json_values.hpp"
#include "cli/output/stages_output.hpp"
#include "reference/files/shape_names.hpp"
#include "view/stages/stages.hpp"

namespace fathom::cli {
namespace {

std::string text_of(const stages::Stages& stages, const Request& request) {
  if (request.json) return stages::to_json(stages);
  return is_stream(request) ? stages_line(stages) : stages_block(stages);
}

}  // namespace

ExitCode run_stages(const Request& request) {
  Replies replies;
  replies.reply = [&](const Case& pair, Monitor& monitor, Workspace&) {
    if (has_shape(pair)) require_depth(pair.id, files::shape_of(pair.a), files::shape_of(pair.b));
    stages::Stages stages = stages::stages_of(pair.a, pair.b, {request.times, &monitor});
    stages.id = pair.id;
    return CaseReply{text_of(stages, request)};
  };
  if (request.json) {
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return error_object("fathom/stages/1", item.id, item.line, fault);
    };
  }
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
