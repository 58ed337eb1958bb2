// SPDX-License-Identifier: GPL-3.0-or-later
// fathom study A B | CASES.jsonl | -
#include <limits>

#include "cli/commands/command.hpp"
#include "cli/commands/replies.hpp"
#include "cli/output/study_output.hpp"
#include "verify/study/study.hpp"

namespace fathom::cli {
namespace {

Study study_of(const Case& pair, const Request& request, Monitor& monitor) {
  StudyOptions options;
  if (request.all) options.listed = std::numeric_limits<std::size_t>::max();
  options.monitor = &monitor;
  return study(pair.a.points, pair.b.points, options);
}

std::string text_of(const std::string& id, const Study& study, const Request& request) {
  if (request.csv) return study_csv_row(id, study);
  if (request.json) return study_json(id, study);
  return is_stream(request) ? study_line(id, study) : study_block(study, request.all);
}

}  // namespace

ExitCode run_study(const Request& request) {
  Replies replies;
  replies.reply = [&](const Case& pair, Monitor& monitor, Workspace&) {
    return CaseReply{text_of(pair.id, study_of(pair, request, monitor), request)};
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
