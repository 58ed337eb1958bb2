// SPDX-License-Identifier: GPL-3.0-or-later
// fathom study A B | CASES.jsonl | -
#include <limits>

#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/output/study_output.hpp"
#include "fathom/signed_depth.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/study/study.hpp"

namespace fathom::cli {
namespace {

StudyOptions options_of(const Request& request, Monitor& monitor) {
  StudyOptions options;
  if (request.all) options.listed = std::numeric_limits<std::size_t>::max();
  options.monitor = &monitor;
  return options;
}

ShapeStudy shape_study_of(const Case& pair, const Request& request, Monitor& monitor) {
  if (request.csv) throw InputError(pair.id, 0, "the rows of --csv are about polytopes, found a shape that is none: --json takes both");
  const Shape a = files::shape_of(pair.a), b = files::shape_of(pair.b);
  require_depth(pair.id, a, b);
  return study(a, b, options_of(request, monitor));
}

std::string text_of(const std::string& id, const ShapeStudy& study, const Request& request) {
  if (request.json) return study_json(id, study);
  return is_stream(request) ? study_line(id, study) : study_block(study, request.all);
}

std::string text_of(const std::string& id, const Study& study, const Request& request) {
  if (request.csv) return study_csv_row(id, study);
  if (request.json) return study_json(id, study);
  return is_stream(request) ? study_line(id, study) : study_block(study, request.all);
}

}  // namespace

ExitCode run_study(const Request& request) {
  if (!request.sweep.family.empty()) return run_sweep(request);
  Replies replies;
  replies.reply = [&](const Case& pair, Monitor& monitor, Workspace&) {
    if (has_shape(pair)) return CaseReply{text_of(pair.id, shape_study_of(pair, request, monitor), request)};
    return CaseReply{text_of(pair.id, study(pair.a.points, pair.b.points, options_of(request, monitor)), request)};
  };
  if (request.csv) {
    replies.header = study_csv_header();
    replies.error_line = [](const CaseItem& item, const std::string& fault) { return study_csv_error(item.id, fault); };
  } else if (request.json) {
    replies.error_line = [](const CaseItem& item, const std::string& fault) { return study_json_error(item.id, item.line, fault); };
  }
  return reply_to_inputs(request, replies);
}

}  // namespace fathom::cli
