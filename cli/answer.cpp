// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/answer.hpp"

#include <stdexcept>
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
  Answer answer{single.id, solve(single, options), single.a.points.size(), single.b.points.size(), ""};
  if (!request.certificate.empty() || request.embed_certificate) {
    const Body& b = request.command == Command::width ? single.a : single.b;
    Certificate certificate = make_certificate(single.a.points, b.points, answer.depth, options);
    certificate.id = single.id;
    answer.certificate = certificate_text(certificate);
  }
  progress.clear();
  return answer;
}

}  // namespace

Answering answer_by(const Request& request, Solve solve) {
  return
      [&request, solve = std::move(solve)](const Case& single, Progress& progress) { return answer_to(single, request, solve, progress); };
}

std::string_view name(Status status) {
  switch (status) {
    case Status::penetrating: return "penetrating";
    case Status::touching: return "touching";
    case Status::disjoint: return "disjoint";
  }
  throw std::logic_error("unknown status");
}

std::string_view name(ContactKind kind) {
  switch (kind) {
    case ContactKind::facet_vertex: return "facet-vertex";
    case ContactKind::vertex_facet: return "vertex-facet";
    case ContactKind::facet_edge: return "facet-edge";
    case ContactKind::edge_facet: return "edge-facet";
    case ContactKind::facet_facet: return "facet-facet";
    case ContactKind::edge_edge: return "edge-edge";
  }
  throw std::logic_error("unknown contact kind");
}

std::string_view name(Method method) {
  switch (method) {
    case Method::exact: return "exact";
    case Method::naive: return "naive";
    case Method::certificate: return "certificate";
    case Method::shallow: return "shallow";
  }
  throw std::logic_error("unknown method");
}

}  // namespace fathom::cli
