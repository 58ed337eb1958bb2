// SPDX-License-Identifier: GPL-3.0-or-later
// The hulls with their Gaussian diagrams, and the answer.
#include <set>

#include "fathom/numbers.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

// Of very many ties, so many are listed.
constexpr std::size_t most_optima = 1000;

std::optional<Index> index_of(gaussian::NodeId node) { return node.is_none() ? std::nullopt : std::optional(node.value); }

void add_diagram(const gaussian::GaussianDiagram& diagram, StagedBody& body) {
  for (const kernels::Direction& node : diagram.nodes) body.nodes.push_back(unit(node.exact()));
  for (const gaussian::Arc& arc : diagram.arcs) {
    body.arcs.push_back({index_of(arc.from), index_of(arc.to)});
    if (diagram.rank < 3) body.circles.push_back(unit(arc.circle.exact()));
  }
}

StagedBody body_of(const polytope::Polytope& hull, const gaussian::GaussianDiagram& diagram, const Placing& placing) {
  StagedBody body;
  body.rank = hull.rank;
  body.ids.assign(hull.input_ids.begin(), hull.input_ids.end());
  for (const Vector& v : hull.vertices) body.vertices.push_back(placing.point(v));
  for (const polytope::Edge& edge : hull.edges) body.edges.push_back({edge.from.value, edge.to.value});
  for (const polytope::Facet& facet : hull.facets) {
    Indices& corners = body.facets.emplace_back();
    for (std::uint32_t i = facet.begin; i < facet.end; ++i) corners.push_back(hull.corners[i].value);
  }
  add_diagram(diagram, body);
  return body;
}

void tell_of_lost_places(std::string_view name, const StagedBody& body, Stages& stages) {
  const std::set<Place> distinct(body.vertices.begin(), body.vertices.end());
  if (distinct.size() < body.vertices.size())
    stages.left_out.push_back(std::string("Vertices of ") + std::string(name) +
                              " fall together in binary64: beside the other body, or along one axis, they are too near each other.");
}

Place times(double length, const Place& direction) {
  return {length * direction[0] + 0.0, length * direction[1] + 0.0, length * direction[2] + 0.0};
}

}  // namespace

void add_bodies(const StagesSource& subject, Stages& stages) {
  stages.scale = subject.placing.scale();
  stages.a = body_of(subject.exact.hulls.a, subject.exact.diagrams.a, subject.placing);
  stages.b = body_of(subject.exact.hulls.b, subject.exact.diagrams.b, subject.placing);
  tell_of_lost_places("A", stages.a, stages);
  tell_of_lost_places("B", stages.b, stages);
}

void add_contact(const Depth& depth, const Placing& placing, Stages& stages) {
  stages.status = depth.status();
  stages.contact.direction = unit(depth.direction());
  if (const Distance* const distance = depth.distance())
    stages.contact.translation = times(-placing.length(distance->squared), stages.contact.direction);
  if (depth.contact()) stages.contact.features = *depth.contact();
  if (!depth.penetration()) return;
  stages.squared = depth.squared();
  if (const double value = root_binary64(*stages.squared); std::isfinite(value) && value > 0) stages.depth = value;
  const double length = placing.length(*stages.squared);
  for (const Optimum& optimum : depth.optima()) {
    if (stages.contact.optima.size() == most_optima) break;
    const Place direction = unit(optimum.direction);
    stages.contact.optima.push_back({direction, times(length, direction), optimum.contact});
  }
  stages.contact.translation = stages.contact.optima.front().translation;
  if (depth.optima_count() > most_optima)
    stages.left_out.push_back("The first " + std::to_string(most_optima) + " of " + std::to_string(depth.optima_count()) +
                              " optima are listed.");
}

}  // namespace fathom::stages
