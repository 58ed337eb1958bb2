// SPDX-License-Identifier: GPL-3.0-or-later
// fathom approx --delta D A B | CASES.jsonl | -          fathom width --delta D A | CASES.jsonl | -
#include "cli/commands/command_approx.hpp"

#include <fmt/format.h>

#include "cli/commands/answer.hpp"
#include "cli/io/output.hpp"
#include "reference/approximate/separation.hpp"
#include "reference/files/mesh.hpp"

namespace fathom::cli {
namespace {

Answer approximate_answer(const Case& single, const Request& request, Progress& progress) {
  const ReportProgress report = [&](const std::string& stage, double share) { return progress.report(stage, share); };
  ApproxDepth found = request.command == Command::width ? approx_width(single.a.points, *request.delta, report)
                                                        : approx_depth(single.a.points, single.b.points, *request.delta, report);
  progress.answered();
  Answer answer{single.id, std::move(found.depth)};
  answer.approximation = Approximation{found.delta, found.rays, found.bound_squared()};
  return answer;
}

/// Not refused: a run can be interrupted, and its progress is shown.
void warn_of_many_rays(const Request& request) {
  constexpr long many = 10'000'000;
  const mpq_class rays = (request.command == Command::width ? 2 : 4) / *request.delta;  // the grid itself takes long to find
  if (rays > many) talk(fmt::format("--delta {} asks for about {} rays a case", exact_text(*request.delta), mpz_class(rays).get_str()));
}

}  // namespace

Answering approximating(const Request& request) {
  warn_of_many_rays(request);
  return [&request](const Case& single, Progress& progress) { return approximate_answer(single, request, progress); };
}

ExitCode run_approx(const Request& request) {
  if (request.inputs.size() == 1) return answer_stream(request, approximating(request));
  const std::string &a = request.inputs[0], &b = request.inputs[1];
  return answer_single(request, {a + " " + b, read_mesh(a, request.decimals), read_mesh(b, request.decimals)}, approximating(request));
}

}  // namespace fathom::cli
