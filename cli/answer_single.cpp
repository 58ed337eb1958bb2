// SPDX-License-Identifier: GPL-3.0-or-later
#include <new>
#include <optional>

#include "cli/answer.hpp"
#include "cli/certificate_file.hpp"
#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/json_result.hpp"
#include "cli/output.hpp"
#include "cli/text_result.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::cli {
namespace {

// The inner polytope needs no hulls; whoever gave a mesh that is not convex is told all the same, as long as that is quick.
void count_extreme_points(const Request& request, const Case& single, Depth& depth) {
  constexpr std::size_t quick = 20000;
  if (depth.method != Method::certificate || single.a.points.size() + single.b.points.size() > quick) return;
  const bool one_body = request.command == Command::width;
  const std::optional<Lattice> lattice = slim_lattice(single.a.points, one_body ? single.a.points : single.b.points);
  if (!lattice) return;
  depth.extreme_a = static_cast<std::uint32_t>(convex_hull(lattice->a).vertices.size());
  if (!one_body) depth.extreme_b = static_cast<std::uint32_t>(convex_hull(lattice->b).vertices.size());
}

}  // namespace

ExitCode answer_single(const Request& request, const Case& single, const Answering& answering) {
  const Working working;
  std::optional<CertificateFile> file;
  if (!request.certificate.empty()) file.emplace(request.certificate);
  Progress progress;
  Answer answer = answering(single, progress);
  count_extreme_points(request, single, answer.depth);
  if (const auto note = hull_note(answer, request)) talk(*note);
  if (file) file->write(answer.certificate);
  print(request.json ? json_result(answer, request) : text_block(answer, request));
  return fine;
}

std::string fault_text(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  return std::string("internal error: ") + error.what();
}

}  // namespace fathom::cli
