// SPDX-License-Identifier: GPL-3.0-or-later
// Coincidences of the two Gaussian diagrams with each other and with the frame v = (0, 1, 0), z = (0, 0, 1).
#include "kernels/predicates/perturbed_kernel.hpp"
#include "verify/study/study.hpp"

namespace fathom::studies {
namespace {

/// Whether u, a direction on the arc's great circle, lies inside the arc, its ends excluded.
bool inside(const gaussian::GaussianDiagram& diagram, const gaussian::Arc& arc, const Vector& u) {
  if (diagram.rank == 1) return true;
  // On an arc shorter than pi only its own directions pass both; on a half-circle the second condition repeats the first.
  return det(diagram.nodes[arc.from].exact(), u, arc.circle.exact()) > 0 && det(u, diagram.nodes[arc.to].exact(), arc.circle.exact()) > 0;
}

bool on_equator(const gaussian::Arc& arc) { return arc.circle.exact().x == 0 && arc.circle.exact().y == 0; }

/// The directions in which arcs of one diagram pass through the equator inside, each with its arc. No two are equal except for bodies of
/// rank 1, whose one arc passes twice: arcs of a diagram do not cross. With d = circle and z the pole, an arc that leaves z's side does
/// so at d x z: it runs on along d x (d x z), which points downward.
ByDirection<gaussian::ArcId> passages(const gaussian::GaussianDiagram& diagram) {
  ByDirection<gaussian::ArcId> result;
  for (const gaussian::ArcId i : diagram.arcs.ids()) {
    const gaussian::Arc& arc = diagram.arcs[i];
    if (on_equator(arc)) continue;
    const Vector leaves = primitive({arc.circle.exact().y, -arc.circle.exact().x, 0});
    if (diagram.rank == 1) {
      result.emplace(leaves, i);
      result.emplace(-leaves, i);
      continue;
    }
    const int from = sgn(diagram.nodes[arc.from].exact().z), to = sgn(diagram.nodes[arc.to].exact().z);
    if (from * to < 0) result.emplace(from > 0 ? leaves : -leaves, i);
  }
  return result;
}

void find_on_equator(const Subject& subject, Findings& findings) {
  for (const gaussian::NodeId i : subject.diagram.nodes.ids())
    if (subject.diagram.nodes[i].exact().z == 0) findings.add(Coincidence::nodes_on_equator, subject.involved({subject.feature(i)}));
  for (const gaussian::ArcId i : subject.diagram.arcs.ids())
    if (on_equator(subject.diagram.arcs[i])) findings.add(Coincidence::arcs_on_equator, subject.involved({subject.feature(i)}));
}

/// Crossings of arcs of `lying` that lie on the equator with those of `passing` that pass through it.
void find_passages_through_arcs(const Subject& lying, const Subject& passing, Findings& findings) {
  const ByDirection<gaussian::ArcId> through = passages(passing.diagram);
  for (const gaussian::ArcId i : lying.diagram.arcs.ids()) {
    const gaussian::Arc& arc = lying.diagram.arcs[i];
    if (!on_equator(arc)) continue;
    for (const auto& [u, j] : through)
      if (inside(lying.diagram, arc, u))
        findings.add(Coincidence::crossings_on_equator, lying.involved({lying.feature(i)}, {passing.feature(j)}));
  }
}

}  // namespace

void find_normals_on_arcs(kernels::Context& context, const Subjects& subjects, Findings& findings) {
  const kernels::UnperturbedKernel kernel(context.counters.predicates);
  const double all = static_cast<double>(subjects.a.diagram.nodes.size() + subjects.b.diagram.nodes.size());
  std::size_t done = 0;
  for (const gaussian::Colour colour : gaussian::both_colours) {
    const Subject &nodes = subjects[colour], &arcs = subjects[other(colour)];
    for (const gaussian::NodeId i : nodes.diagram.nodes.ids()) {
      context.report("normals on arcs", static_cast<double>(done++) / all);
      const kernels::Direction& node = nodes.diagram.nodes[i];
      for (const gaussian::ArcId j : arcs.diagram.arcs.ids()) {
        const gaussian::Arc& arc = arcs.diagram.arcs[j];
        if (kernel.side_of_arc(node, arc.circle) != kernels::Sign::zero || !inside(arcs.diagram, arc, node.exact())) continue;
        findings.add(Coincidence::normals_on_arcs, nodes.involved({nodes.feature(i)}, {arcs.feature(j)}));
      }
    }
  }
}

void find_equator_hits(const Subjects& subjects, Findings& findings) {
  const auto& [a, b] = subjects;
  find_on_equator(a, findings);
  find_on_equator(b, findings);
  const ByDirection<gaussian::ArcId> of_a = passages(a.diagram), of_b = passages(b.diagram);
  for (const auto& [u, e] : of_a) {
    const auto found = of_b.find(u);
    if (found == of_b.end()) continue;
    const gaussian::ArcId f = found->second;
    const bool one_circle = is_zero(cross(a.diagram.arcs[e].circle.exact(), b.diagram.arcs[f].circle.exact()));
    if (!one_circle) findings.add(Coincidence::crossings_on_equator, {{a.feature(e)}, {b.feature(f)}});
  }
  find_passages_through_arcs(a, b, findings);
  find_passages_through_arcs(b, a, findings);
}

// Nodes n of one hemisphere share an abscissa when (n.x, n.z) have one direction.
void find_verticals(const Subjects& subjects, Findings& findings) {
  ByDirection<gaussian::PerColour<std::vector<gaussian::NodeId>>> groups;
  for (const gaussian::Colour colour : gaussian::both_colours) {
    const Subject& subject = subjects[colour];
    for (const gaussian::NodeId i : subject.diagram.nodes.ids()) {
      const Vector& n = subject.diagram.nodes[i].exact();
      if (n.z != 0) groups[primitive({n.x, 0, n.z})][colour].push_back(i);
    }
    for (const gaussian::ArcId i : subject.diagram.arcs.ids())
      if (subject.diagram.arcs[i].circle.exact().y == 0)
        findings.add(Coincidence::arcs_on_verticals, subject.involved({subject.feature(i)}));
  }
  for (const auto& [abscissa, nodes] : groups) {
    findings.add_pairs(Coincidence::nodes_on_one_vertical, subjects, nodes);
    findings.add_pairs(Coincidence::nodes_on_one_vertical, subjects.a, nodes.a);
    findings.add_pairs(Coincidence::nodes_on_one_vertical, subjects.b, nodes.b);
  }
}

}  // namespace fathom::studies
