// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/stages/decisions.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/chart/chart.hpp"

namespace fathom::stages {
namespace {

/// The frame of the upper hemisphere: the lower one's pole gives the same monomials.
const chart::Frame& frame() {
  static const chart::Frame upper = chart::chart_frame(chart::Hemisphere::upper);
  return upper;
}

}  // namespace

Decisions::Decisions(const studies::Subjects& subjects, const kernels::Perturbation& perturbation)
    : subjects_(subjects), perturbation_(perturbation), features_{features_of(subjects.a), features_of(subjects.b)} {}

Decisions::Features Decisions::features_of(const studies::Subject& subject) {
  Features result;
  for (const gaussian::ArcId i : subject.diagram.arcs.ids()) result.arcs.emplace(subject.feature(i), i);
  for (const gaussian::NodeId i : subject.diagram.nodes.ids()) result.nodes.emplace(subject.feature(i), i);
  return result;
}

std::vector<Decisions::Member> Decisions::members(const Involved& involved) {
  std::vector<Member> result;
  for (const Feature& feature : involved.a) result.push_back({gaussian::Colour::a, &feature});
  for (const Feature& feature : involved.b) result.push_back({gaussian::Colour::b, &feature});
  return result;
}

const gaussian::Arc* Decisions::arc(const Member& member) const {
  const auto& arcs = features_[member.colour].arcs;
  const auto found = arcs.find(*member.feature);
  return found == arcs.end() ? nullptr : &subjects_[member.colour].diagram.arcs[found->second];
}

const kernels::Direction* Decisions::node(const Member& member) const {
  const auto& nodes = features_[member.colour].nodes;
  const auto found = nodes.find(*member.feature);
  return found == nodes.end() ? nullptr : &subjects_[member.colour].diagram.nodes[found->second];
}

const kernels::Direction& Decisions::end(const Member& member, gaussian::NodeId i) const {
  return subjects_[member.colour].diagram.nodes[i];
}

void Decisions::ask_of_edges(const kernels::PerturbedKernel& kernel, Coincidence kind, const std::vector<Member>& all) const {
  for (const Member& member : all) {
    const gaussian::Arc* const own = arc(member);
    if (own == nullptr || subjects_[member.colour].diagram.rank < 2) return;  // a full circle has no ends
    const kernels::Direction &from = end(member, own->from), &to = end(member, own->to);
    if (kind == Coincidence::arcs_on_equator) {
      (void)kernel.side_of_equator(from, frame().z);
      (void)kernel.side_of_equator(to, frame().z);
    } else if (kind == Coincidence::arcs_on_verticals) {
      if (subjects_[member.colour].diagram.rank == 3) (void)kernel.x_order(from, to, frame().v);
    } else if (const gaussian::Arc* const other = arc(all[member.feature == all[0].feature ? 1 : 0])) {
      (void)kernel.side_of_arc(from, other->circle);
      (void)kernel.side_of_arc(to, other->circle);
    }
  }
}

void Decisions::ask(const kernels::PerturbedKernel& kernel, Coincidence kind, const std::vector<Member>& all) const {
  switch (kind) {
    case Coincidence::parallel_edges:
    case Coincidence::arcs_on_equator:
    case Coincidence::arcs_on_verticals: return ask_of_edges(kernel, kind, all);
    case Coincidence::normals_on_arcs: {
      const bool a_is_facet = node(all[0]) != nullptr;
      const kernels::Direction* const facet = node(all[a_is_facet ? 0 : 1]);
      const gaussian::Arc* const edge = arc(all[a_is_facet ? 1 : 0]);
      if (facet != nullptr && edge != nullptr) (void)kernel.side_of_arc(*facet, edge->circle);
      return;
    }
    case Coincidence::nodes_on_equator:
      if (node(all[0]) != nullptr) (void)kernel.side_of_equator(*node(all[0]), frame().z);
      return;
    case Coincidence::coincident_normals:
    case Coincidence::nodes_on_one_vertical:
      if (node(all[0]) != nullptr && node(all[1]) != nullptr) (void)kernel.x_order(*node(all[0]), *node(all[1]), frame().v);
      return;
    case Coincidence::crossings_on_equator:
      if (arc(all[0]) != nullptr && arc(all[1]) != nullptr)
        (void)kernel.order_at_infinity(arc(all[0])->circle, arc(all[1])->circle, frame().z);
      return;
    default: return;
  }
}

std::vector<std::string> Decisions::about(Coincidence kind, const Involved& involved) const {
  PredicateCounts counts{};
  try {
    ask(kernels::PerturbedKernel(perturbation_, counts), kind, members(involved));
  } catch (const std::logic_error&) {  // not a question that the perturbation answers: the method never asks it
    return {};
  }
  std::vector<std::string> names;
  for (const TierCounts& asked : counts)
    for (const auto& [monomial, count] : asked.decided)
      if (const std::string name = monomial_name(monomial); std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

}  // namespace fathom::stages
