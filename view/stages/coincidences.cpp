// SPDX-License-Identifier: GPL-3.0-or-later
// The coincidences under their names in the study, and the monomials of the perturbation that
// resolve them. Part of parts.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "kernels/predicates/perturbed_kernel.hpp"
#include "reference/chart/chart.hpp"
#include "verify/study/study.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

/// The frame of the upper hemisphere: the lower one's pole gives the same monomials.
const chart::Frame& frame() {
  static const chart::Frame upper = chart::chart_frame(chart::Hemisphere::upper);
  return upper;
}

/// Finds the monomials of the perturbation that resolve a coincidence: it calls the predicate that
/// the coincidence makes zero with the perturbed kernel. [proofs/perturbation.md]
class Decisions {
 public:
  /// The bodies must outlive it.
  Decisions(const studies::StudiedBodies& bodies, const kernels::Perturbation& perturbation);

  /// Returns the names of the monomials that decide about these features, each once; empty if the
  /// method calls no predicate that they make zero, as for bodies that only tie.
  [[nodiscard]] std::vector<std::string> about(Coincidence kind, const Involved& involved) const;

 private:
  /// The edges and facets, by their points.
  struct Features {
    std::map<Feature, gaussian::ArcId> arcs;
    std::map<Feature, gaussian::NodeId> nodes;
  };
  /// A feature with its colour.
  struct Member {
    gaussian::Colour colour;
    const Feature* feature;
  };

  static Features features_of(const studies::StudiedBody& studied);
  static std::vector<Member> members(const Involved& involved);
  [[nodiscard]] const gaussian::Arc* arc(const Member& member) const;
  [[nodiscard]] const kernels::Direction* node(const Member& member) const;
  [[nodiscard]] const kernels::Direction& end(const Member& member, gaussian::NodeId i) const;
  void ask(const kernels::PerturbedKernel& kernel, Coincidence kind, const std::vector<Member>& all) const;
  void ask_of_edges(const kernels::PerturbedKernel& kernel, Coincidence kind, const std::vector<Member>& all) const;

  const studies::StudiedBodies& bodies_;
  kernels::Perturbation perturbation_;
  gaussian::PerColour<Features> features_;
};

Decisions::Decisions(const studies::StudiedBodies& bodies, const kernels::Perturbation& perturbation)
    : bodies_(bodies), perturbation_(perturbation), features_{features_of(bodies.a), features_of(bodies.b)} {}

Decisions::Features Decisions::features_of(const studies::StudiedBody& studied) {
  Features result;
  for (const gaussian::ArcId i : studied.diagram.arcs.ids()) result.arcs.emplace(studied.feature(i), i);
  for (const gaussian::NodeId i : studied.diagram.nodes.ids()) result.nodes.emplace(studied.feature(i), i);
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
  return found == arcs.end() ? nullptr : &bodies_[member.colour].diagram.arcs[found->second];
}

const kernels::Direction* Decisions::node(const Member& member) const {
  const auto& nodes = features_[member.colour].nodes;
  const auto found = nodes.find(*member.feature);
  return found == nodes.end() ? nullptr : &bodies_[member.colour].diagram.nodes[found->second];
}

const kernels::Direction& Decisions::end(const Member& member, gaussian::NodeId i) const {
  return bodies_[member.colour].diagram.nodes[i];
}

void Decisions::ask_of_edges(const kernels::PerturbedKernel& kernel, Coincidence kind,
                             const std::vector<Member>& all) const {
  for (const Member& member : all) {
    const gaussian::Arc* const own = arc(member);
    if (own == nullptr || bodies_[member.colour].diagram.rank < 2) return;  // full circles have no ends
    const kernels::Direction &from = end(member, own->from), &to = end(member, own->to);
    if (kind == Coincidence::arcs_on_equator) {
      (void)kernel.side_of_equator(from, frame().z);
      (void)kernel.side_of_equator(to, frame().z);
    } else if (kind == Coincidence::arcs_on_verticals) {
      if (bodies_[member.colour].diagram.rank == 3) (void)kernel.x_order(from, to, frame().v);
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
      if (node(all[0]) != nullptr && node(all[1]) != nullptr)
        (void)kernel.x_order(*node(all[0]), *node(all[1]), frame().v);
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
  } catch (const std::logic_error&) {  // the perturbation does not answer it, so the method never asks it
    return {};
  }
  std::vector<std::string> names;
  for (const TierCounts& asked : counts)
    for (const auto& [monomial, count] : asked.decided)
      if (const std::string name = monomial_name(monomial); std::ranges::find(names, name) == names.end())
        names.push_back(name);
  return names;
}

Study study_of(const StagesSource& source, const studies::StudiedBodies& bodies, Stages& stages) {
  Study study;
  studies::Findings findings(study, source.options.listed);
  const std::uint64_t most = source.options.most_pairs, pairs = studies::pairs_to_test(bodies);
  studies::find_coincidences(source.context, bodies, {1, 1, 1}, source.exact.depth, findings, most);
  if (pairs > most)
    stages.left_out.push_back(
        fmt::format("Normals of one body on arcs of the other were not looked for: {} pairs are too many here; fathom "
                    "study looks at all.",
                    pairs));
  return study;
}

}  // namespace

std::vector<StagedCoincidence> staged(const std::array<Coincidences, coincidence_names.size()>& found) {
  std::vector<StagedCoincidence> result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i].count == 0) continue;
    StagedCoincidence& kind = result.emplace_back(StagedCoincidence{coincidence_names[i], found[i].count, {}});
    for (const Involved& involved : found[i].listed) kind.listed.push_back({involved.a, involved.b, {}});
  }
  return result;
}

void add_decided(const PredicateCounts& counts, Stages& stages) {
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& asked = counts[i];
    StagedDecision decision{predicate_names[i], asked.calls, asked.exact, asked.zero, {}};
    for (const auto& [monomial, count] : asked.decided) decision.monomials.push_back({monomial_name(monomial), count});
    stages.decided.push_back(std::move(decision));
  }
}

void add_coincidences(const StagesSource& source, Stages& stages) {
  const depth::ExactStages& exact = source.exact;
  const studies::StudiedBodies bodies{{gaussian::Colour::a, exact.hulls.a, exact.diagrams.a},
                                      {gaussian::Colour::b, exact.hulls.b, exact.diagrams.b}};
  stages.coincidences = staged(study_of(source, bodies, stages).coincidences);
  const Decisions decisions(bodies, exact.charts[0].perturbation);
  for (StagedCoincidence& found : stages.coincidences) {
    const auto kind =
        static_cast<Coincidence>(std::ranges::find(coincidence_names, found.kind) - coincidence_names.begin());
    for (StagedInvolved& involved : found.listed) involved.decided_by = decisions.about(kind, {involved.a, involved.b});
  }
}

}  // namespace fathom::stages
