// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/answer.hpp"

#include <utility>

#include "reference/certificate/certificate.hpp"

namespace fathom::cli {

namespace {

Answer answer_to(const Case& single, const Request& request, const Solve& solve, Progress& progress) {
  Options options;
  options.method = request.method;
  options.closest_lines = request.closest_lines;
  options.seed = request.seed;
  options.progress = [&](const std::string& stage, double share) { return progress.report(stage, share); };
  Answer answer{single.id, solve(single, options)};
  if (!request.certificate.empty() || request.embed_certificate) {
    const Body& b = request.command == Command::width ? single.a : single.b;
    Certificate certificate = make_certificate(single.a.points, b.points, answer.depth, options);
    certificate.id = single.id;
    answer.certificate = certificate_text(certificate);
  }
  progress.answered();
  return answer;
}

}  // namespace

Answering answer_by(const Request& request, Solve solve) {
  return
      [&request, solve = std::move(solve)](const Case& single, Progress& progress) { return answer_to(single, request, solve, progress); };
}

}  // namespace fathom::cli
