// SPDX-License-Identifier: GPL-3.0-or-later
// fathom study A B | CASES.jsonl | -
#include <limits>

#include "cli/commands/command.hpp"
#include "cli/io/case_stream.hpp"
#include "cli/io/interrupt.hpp"
#include "cli/io/output.hpp"
#include "cli/output/hull_note.hpp"
#include "cli/output/study_output.hpp"
#include "reference/files/mesh.hpp"
#include "verify/study/study.hpp"

namespace fathom::cli {
namespace {

Study study_of(const Case& pair, const Request& request, Progress& progress) {
  StudyOptions options;
  if (request.all) options.listed = std::numeric_limits<std::size_t>::max();
  options.progress = [&](const std::string& stage, double share) { return progress.report(stage, share); };
  Study result = study(pair.a.points, pair.b.points, options);
  progress.answered();
  return result;
}

ExitCode study_single(const Request& request, const Case& pair) {
  const Working working;
  Progress progress;
  const Study study = study_of(pair, request, progress);
  tell_of_hulls(pair, false, progress);
  if (request.csv) print(study_csv_header());
  print(request.csv ? study_csv_row(pair.id, study) : request.json ? study_json(pair.id, study) : study_block(study, request.all));
  return fine;
}

ExitCode study_stream(const Request& request) {
  StreamWork work;
  work.answer = [&](const Case& pair, Progress& progress) {
    const Study study = study_of(pair, request, progress);
    print(request.csv ? study_csv_row(pair.id, study) : request.json ? study_json(pair.id, study) : study_line(pair.id, study));
  };
  if (request.csv) {
    work.header = study_csv_header();
    work.error_line = [](const CaseItem& item, const std::string& fault) { return study_csv_error(item.id, fault); };
  } else if (request.json) {
    work.error_line = [](const CaseItem& item, const std::string& fault) { return study_json_error(item.id, item.line, fault); };
  }
  return for_each_case(request.inputs[0], work);
}

}  // namespace

ExitCode run_study(const Request& request) {
  if (request.inputs.size() == 1) return study_stream(request);
  const std::string &a = request.inputs[0], &b = request.inputs[1];
  return study_single(request, {a + " " + b, read_mesh(a, request.decimals), read_mesh(b, request.decimals)});
}

}  // namespace fathom::cli
