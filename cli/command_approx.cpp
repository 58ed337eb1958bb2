// SPDX-License-Identifier: GPL-3.0-or-later
// fathom approx --delta D A B | CASES.jsonl | -          fathom width --delta D A | CASES.jsonl | -
#include "cli/command_approx.hpp"

#include <fmt/format.h>

#include "cli/answer.hpp"
#include "cli/case_stream.hpp"
#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/json_result.hpp"
#include "cli/output.hpp"
#include "cli/text_result.hpp"
#include "reference/approximate/separation.hpp"
#include "reference/files/mesh.hpp"

namespace fathom::cli {
namespace {

Answer approximate_answer(const Case& single, const Request& request, Progress& progress) {
  const ReportProgress report = [&](const std::string& stage, double share) { return progress.report(stage, share); };
  ApproxDepth found = request.command == Command::width ? approx_width(single.a.points, *request.delta, report)
                                                        : approx_depth(single.a.points, single.b.points, *request.delta, report);
  progress.clear();
  Answer answer{single.id, std::move(found.depth), single.a.points.size(), single.b.points.size()};
  answer.approximation = Approximation{found.delta, found.rays, found.bound_squared};
  return answer;
}

}  // namespace

ExitCode approximate_single(const Request& request, const Case& single) {
  const Working working;
  Progress progress;
  const Answer answer = approximate_answer(single, request, progress);
  if (const auto note = hull_note(answer, request)) talk(*note);
  print(request.json ? json_result(answer, request) : text_block(answer, request));
  return fine;
}

ExitCode approximate_stream(const Request& request) {
  std::size_t cases = 0, hulls = 0;
  StreamWork work;
  work.answer = [&](const Case& single, Progress& progress) {
    const Answer answer = approximate_answer(single, request, progress);
    if (hull_note(answer, request)) ++hulls;
    print(request.json ? json_result(answer, request) : text_line(answer, request));
  };
  if (request.json) work.error_line = [](const CaseItem& item, const std::string& fault) { return json_error(item.id, item.line, fault); };
  const ExitCode code = for_each_case(request.inputs[0], work, &cases);
  if (hulls > 0) talk(fmt::format("{} of {} cases had points that are not extreme; convex hulls were taken", hulls, cases));
  return code;
}

ExitCode run_approx(const Request& request) {
  if (request.inputs.size() == 1) return approximate_stream(request);
  const std::string &a = request.inputs[0], &b = request.inputs[1];
  return approximate_single(request, {a + " " + b, read_mesh(a, request.decimals), read_mesh(b, request.decimals)});
}

}  // namespace fathom::cli
