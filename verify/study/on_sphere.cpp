// SPDX-License-Identifier: GPL-3.0-or-later
// Coincidences of the two Gaussian diagrams with each other and with the frame v = (0, 1, 0), z = (0, 0, 1).
#include <map>

#include "kernels/predicates/perturbed_kernel.hpp"
#include "verify/study/findings.hpp"

namespace fathom::studies {
namespace {

/// Whether u, a direction on the arc's great circle, lies inside the arc, its ends excluded.
bool inside(const gaussian::GaussianDiagram& diagram, const gaussian::Arc& arc, const Vector& u) {
  if (diagram.rank == 1) return true;
  // On an arc shorter than pi only its own directions pass both; on a half-circle the second condition repeats the first.
  return det(diagram.nodes[arc.from].exact(), u, arc.circle.exact()) > 0 && det(u, diagram.nodes[arc.to].exact(), arc.circle.exact()) > 0;
}

/// An arc's feature where it stands for an edge of A (`of_a`) or of B.
Involved one_edge(const Subject& subject, bool of_a, std::uint32_t i) {
  return of_a ? Involved{{subject.edge(i)}, {}} : Involved{{}, {subject.edge(i)}};
}

Involved one_facet(const Subject& subject, bool of_a, std::uint32_t i) {
  return of_a ? Involved{{subject.facet(i)}, {}} : Involved{{}, {subject.facet(i)}};
}

bool on_equator(const gaussian::Arc& arc) { return arc.circle.exact().x == 0 && arc.circle.exact().y == 0; }

/// The directions in which arcs of one diagram pass through the equator inside, each with its arc. No two are equal except for bodies of
/// rank 1, whose one arc passes twice: arcs of a diagram do not cross. With d = circle and z the pole, an arc that leaves z's side does
/// so at d x z: it runs on along d x (d x z), which points downward.
std::map<Vector, std::uint32_t, LexicographicOrder> passages(const gaussian::GaussianDiagram& diagram) {
  std::map<Vector, std::uint32_t, LexicographicOrder> result;
  for (std::uint32_t i = 0; i < diagram.arcs.size(); ++i) {
    const gaussian::Arc& arc = diagram.arcs[gaussian::ArcId(i)];
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

void find_on_equator(const Subject& subject, bool of_a, Findings& findings) {
  for (std::uint32_t i = 0; i < subject.diagram.nodes.size(); ++i) {
    if (subject.diagram.nodes[gaussian::NodeId(i)].exact().z == 0) findings.add(Coincidence::nodes_on_equator, one_facet(subject, of_a, i));
  }
  for (std::uint32_t i = 0; i < subject.diagram.arcs.size(); ++i) {
    if (on_equator(subject.diagram.arcs[gaussian::ArcId(i)])) findings.add(Coincidence::arcs_on_equator, one_edge(subject, of_a, i));
  }
}

/// Crossings of arcs of `lying` that lie on the equator with those of `passing` that pass through it. `a_lies`: `lying` is A.
void find_passages_through_arcs(const Subject& lying, const Subject& passing, bool a_lies, Findings& findings) {
  const auto through = passages(passing.diagram);
  for (std::uint32_t i = 0; i < lying.diagram.arcs.size(); ++i) {
    if (!on_equator(lying.diagram.arcs[gaussian::ArcId(i)])) continue;
    for (const auto& [u, j] : through) {
      if (!inside(lying.diagram, lying.diagram.arcs[gaussian::ArcId(i)], u)) continue;
      findings.add(Coincidence::crossings_on_equator,
                   a_lies ? Involved{{lying.edge(i)}, {passing.edge(j)}} : Involved{{passing.edge(j)}, {lying.edge(i)}});
    }
  }
}

}  // namespace

void find_normals_on_arcs(kernels::Context& context, const Subject& a, const Subject& b, Findings& findings) {
  const kernels::UnperturbedKernel kernel(context.counters.predicates);
  const double all = static_cast<double>(a.diagram.nodes.size() + b.diagram.nodes.size());
  std::size_t done = 0;
  for (const bool node_of_a : {true, false}) {
    const Subject &nodes = node_of_a ? a : b, &arcs = node_of_a ? b : a;
    for (std::uint32_t i = 0; i < nodes.diagram.nodes.size(); ++i) {
      context.report("normals on arcs", static_cast<double>(done++) / all);
      const kernels::Direction& node = nodes.diagram.nodes[gaussian::NodeId(i)];
      for (std::uint32_t j = 0; j < arcs.diagram.arcs.size(); ++j) {
        const gaussian::Arc& arc = arcs.diagram.arcs[gaussian::ArcId(j)];
        if (kernel.side_of_arc(node, arc.circle) != kernels::Sign::zero || !inside(arcs.diagram, arc, node.exact())) continue;
        findings.add(Coincidence::normals_on_arcs, node_of_a ? Involved{{a.facet(i)}, {b.edge(j)}} : Involved{{a.edge(j)}, {b.facet(i)}});
      }
    }
  }
}

void find_equator_hits(const Subject& a, const Subject& b, Findings& findings) {
  find_on_equator(a, true, findings);
  find_on_equator(b, false, findings);
  const auto of_a = passages(a.diagram), of_b = passages(b.diagram);
  for (const auto& [u, e] : of_a) {
    const auto found = of_b.find(u);
    if (found == of_b.end()) continue;
    const bool one_circle =
        is_zero(cross(a.diagram.arcs[gaussian::ArcId(e)].circle.exact(), b.diagram.arcs[gaussian::ArcId(found->second)].circle.exact()));
    if (!one_circle) findings.add(Coincidence::crossings_on_equator, {{a.edge(e)}, {b.edge(found->second)}});
  }
  find_passages_through_arcs(a, b, true, findings);
  find_passages_through_arcs(b, a, false, findings);
}

// Nodes n of one hemisphere share an abscissa when (n.x, n.z) have one direction.
void find_verticals(const Subject& a, const Subject& b, Findings& findings) {
  std::map<Vector, std::array<std::vector<std::uint32_t>, 2>, LexicographicOrder> groups;
  for (const bool of_a : {true, false}) {
    const Subject& subject = of_a ? a : b;
    for (std::uint32_t i = 0; i < subject.diagram.nodes.size(); ++i) {
      const Vector& n = subject.diagram.nodes[gaussian::NodeId(i)].exact();
      if (n.z != 0) groups[primitive({n.x, 0, n.z})][of_a ? 0 : 1].push_back(i);
    }
    for (std::uint32_t i = 0; i < subject.diagram.arcs.size(); ++i) {
      if (subject.diagram.arcs[gaussian::ArcId(i)].circle.exact().y == 0)
        findings.add(Coincidence::arcs_on_verticals, one_edge(subject, of_a, i));
    }
  }
  for (const auto& [abscissa, nodes] : groups) {
    constexpr Coincidence kind = Coincidence::nodes_on_one_vertical;
    findings.add_pairs(kind, nodes[0], nodes[1], [&](std::uint32_t f, std::uint32_t g) -> Involved {
      return {{a.facet(f)}, {b.facet(g)}};
    });
    findings.add_pairs(kind, nodes[0], [&](std::uint32_t f, std::uint32_t g) -> Involved { return {{a.facet(f), a.facet(g)}, {}}; });
    findings.add_pairs(kind, nodes[1], [&](std::uint32_t f, std::uint32_t g) -> Involved { return {{}, {b.facet(f), b.facet(g)}}; });
  }
}

}  // namespace fathom::studies
