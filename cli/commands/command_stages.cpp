// SPDX-License-Identifier: GPL-3.0-or-later
// fathom stages A B | CASES.jsonl | -
#include "cli/commands/command.hpp"


#include "cli/commands/replies.hpp"
#include "cli/output/stages_output.hpp"
#include "reference/files/shape_names.hpp"
#include "reference/output/json_values.hpp"
#include "view/stages/charts_picture.hpp"
#include "view/stages/stages.hpp"

namespace fathom::cli {
namespace {

std::string text_of(const stages::Stages& stages, const Request& request) {
  if (request.json) return stages::to_json(stages);
  return is_stream(request) ? stages_line(stages) : stages_block(stages);
}

/// Throws InputError if there is nothing to be drawn.
std::string picture_of(const Case& pair, const stages::Stages& stages) {
  if (stages.charts.empty()) throw InputError(pair.id, 0, "--svg draws the charts of polytopes, found a shape that is none");
  return stages::charts_file(stages);
}

}  // namespace

ExitCode run_stages(const Request& request) {
  Replies replies;
  const auto pictures = std::make_shared<FilePlaces>(request, request.svg, "picture", ".svg");
  replies.reply = [&request, pictures](const Case& pair, Monitor& monitor, Workspace&) {
    const std::unique_ptr<CertificateFile> drawing = pictures->single();  // an unwritable path fails early
    if (has_shape(pair)) require_depth(pair.id, files::shape_of(pair.a), files::shape_of(pair.b));
    stages::Stages stages = stages::stages_of(pair.a, pair.b, {request.times, &monitor});
    stages.id = pair.id;
    CaseReply reply{text_of(stages, request)};
    const std::string picture = pictures->wanted() ? picture_of(pair, stages) : "";
    if (drawing) drawing->write(picture);
    else if (pictures->wanted()) reply.keep = [pictures, picture, id = pair.id] { pictures->write_to_folder(id, picture); };
    return reply;
  };
  if (request.json) {
    replies.error_line = [](const CaseItem& item, const std::string& fault) {
      return output::error_object("fathom/stages/1", item.id, item.line, fault);
    };
  }
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
