// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the study for what coincides, and which monomials of the perturbation decide it. Part of parts.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "reference/depth/contact.hpp"
#include "verify/study/study.hpp"
#include "view/stages/decisions.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

constexpr std::size_t most_listed = 20;           // of a kind, as `fathom study` lists
constexpr std::uint64_t most_tests = 50'000'000;  // of nodes against arcs, a second or two

/// How many pairs of a node and an arc the search for normals on arcs looks at.
std::uint64_t tests(const studies::Subjects& subjects) {
  const auto &a = subjects.a.diagram, &b = subjects.b.diagram;
  return std::uint64_t{a.nodes.size()} * b.arcs.size() + std::uint64_t{b.nodes.size()} * a.arcs.size();
}

void find_contacts(const StagesSource& subject, studies::Findings& findings) {
  const Depth& depth = subject.exact.depth;
  if (depth.touch()) {
    const depth::FacingFaces faces = depth::facing_faces(subject.pair, depth.touch()->direction);
    findings.add(Coincidence::touching_features, {{faces.a.ids}, {faces.b.ids}});
  }
  if (depth.optima().size() < 2) return;
  for (const Optimum& optimum : depth.optima()) findings.add(Coincidence::ties, {{optimum.contact.a}, {optimum.contact.b}});
}

Study study_of(const StagesSource& subject, const studies::Subjects& subjects, Stages& stages) {
  Study study;
  studies::Findings findings(study, most_listed);
  subject.context.report("coincidences");
  studies::find_parallel_edges(subjects, findings);
  studies::find_common_normals(subjects, findings);
  if (tests(subjects) <= most_tests) studies::find_normals_on_arcs(subject.context, subjects, findings);
  else
    stages.left_out.push_back(
        fmt::format("Normals of one body on arcs of the other were not looked for: {} pairs are too many here; fathom "
                    "study looks at all.",
                    tests(subjects)));
  studies::find_equator_hits(subjects, findings);
  studies::find_verticals(subjects, findings);
  find_contacts(subject, findings);
  return study;
}

}  // namespace

void add_coincidences(const StagesSource& subject, Stages& stages) {
  const depth::ExactStages& exact = subject.exact;
  const studies::Subjects subjects{{gaussian::Colour::a, exact.hulls.a, exact.diagrams.a},
                                   {gaussian::Colour::b, exact.hulls.b, exact.diagrams.b}};
  const Study study = study_of(subject, subjects, stages);
  const Decisions decisions(subjects, exact.charts[0].perturbation);
  for (std::size_t i = 0; i < study.coincidences.size(); ++i) {
    const Coincidences& found = study.coincidences[i];
    if (found.count == 0) continue;
    StagedCoincidence staged{coincidence_names[i], found.count, {}};
    for (const Involved& involved : found.listed)
      staged.listed.push_back({involved.a, involved.b, decisions.about(static_cast<Coincidence>(i), involved)});
    stages.coincidences.push_back(std::move(staged));
  }
  for (std::size_t i = 0; i < predicate_names.size(); ++i) {
    const TierCounts& counts = stages.counters.predicates[i];
    StagedDecision decision{predicate_names[i], counts.zero, {}};
    for (const auto& [monomial, count] : counts.decided) decision.monomials.push_back({monomial_name(monomial), count});
    stages.decided.push_back(std::move(decision));
  }
}

}  // namespace fathom::stages
