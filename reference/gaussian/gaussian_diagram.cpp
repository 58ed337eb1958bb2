// SPDX-License-Identifier: GPL-3.0-or-later

#include "reference/gaussian/gaussian_diagram.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace fathom::gaussian {
namespace {

// For B: the face on the side of d = to - from is the edge's head, since <u,d> > 0 prefers it.
// Between the normals of the left and of the right facet the arc runs on the circle of left x
// right, a positive multiple of d. Reflection negates both normals and both points: the circle
// stays, head and tail change places.
GaussianDiagram diagram(const polytope::Polytope& polytope, Colour colour) {
  const bool reflected = colour == Colour::a;
  GaussianDiagram result;
  result.rank = polytope.rank;
  result.nodes.reserve(polytope.facets.size());
  for (const polytope::Facet& facet : polytope.facets) {
    result.nodes.emplace_back(reflected ? -facet.normal : facet.normal,
                              reflected ? kernels::Role::node_of_a : kernels::Role::fixed);
  }
  result.arcs.reserve(polytope.edges.size());
  for (const polytope::Edge& edge : polytope.edges) {
    kernels::Direction circle(polytope.vertices[edge.to] - polytope.vertices[edge.from],
                              reflected ? kernels::Role::circle_of_a : kernels::Role::fixed);
    Arc arc{std::move(circle), node_of(edge.left), node_of(edge.right), edge.to, edge.from};
    if (reflected) std::swap(arc.above, arc.below);
    result.arcs.push_back(std::move(arc));
  }
  return result;
}

// All indices of nodes and vertices exist; then the other laws may be looked at.
bool in_range(const GaussianDiagram& diagram, const polytope::Polytope& polytope) {
  const auto node = [&](NodeId n) { return diagram.rank == 1 ? n.is_none() : n.value < diagram.nodes.size(); };
  const auto face = [&](VertexId v) { return v.value < polytope.vertices.size(); };
  return std::all_of(diagram.arcs.begin(), diagram.arcs.end(), [&](const Arc& arc) {
    return node(arc.from) && node(arc.to) && face(arc.above) && face(arc.below);
  });
}

// Around a face on the left, an arc leads from a node to the next: each node of the face is entered
// and left equally often.
bool faces_close_up(const GaussianDiagram& diagram) {
  using NodeOfFace = std::pair<VertexId, NodeId>;
  std::vector<NodeOfFace> left, entered;
  for (const Arc& arc : diagram.arcs) {
    left.insert(left.end(), {{arc.above, arc.from}, {arc.below, arc.to}});
    entered.insert(entered.end(), {{arc.above, arc.to}, {arc.below, arc.from}});
  }
  std::sort(left.begin(), left.end());
  std::sort(entered.begin(), entered.end());
  return left == entered;
}

void check_ends(kernels::Report& report, const GaussianDiagram& diagram, const Arc& arc, const Vector& step,
                const std::string& name) {
  const Vector& from = diagram.nodes[arc.from].exact();
  const Vector& to = diagram.nodes[arc.to].exact();
  if (diagram.rank == 2) {
    report.expect(arc.from == NodeId(0) && arc.to == NodeId(1) && same_direction(-from, to),
                  name + "a half-circle joins node 0 to the antipodal node 1");
  } else {
    report.expect(same_direction(cross(from, to), arc.circle.exact()),
                  name + "circle is not a positive multiple of from x to");
  }
  report.expect(dot(from, step) == 0 && dot(to, step) == 0, name + "an end prefers one of its faces");
}

// How the arc's interior crosses the circle. A full circle does both.
struct Senses {
  bool leaves = false;  // the circle's positive side
  bool enters = false;
};

template <class Kernel>
Senses crossing_senses(const Kernel& kernel, const GaussianDiagram& diagram, const Arc& arc,
                       const kernels::Direction& circle) {
  if (diagram.rank == 1) return {true, true};
  const kernels::Sign from = kernel.side_of_arc(diagram.nodes[arc.from], circle);
  const kernels::Sign to = kernel.side_of_arc(diagram.nodes[arc.to], circle);
  if (from * to != kernels::Sign::negative) return {};
  return {from == kernels::Sign::positive, to == kernels::Sign::positive};
}

template <class Kernel>
std::vector<kernels::Sign> crossings(const Kernel& kernel, const GaussianDiagram& of_e, const Arc& e,
                                     const GaussianDiagram& of_f, const Arc& f) {
  const Senses of_arc_e = crossing_senses(kernel, of_e, e, f.circle);
  if (!of_arc_e.leaves && !of_arc_e.enters) return {};
  const Senses of_arc_f = crossing_senses(kernel, of_f, f, e.circle);
  std::vector<kernels::Sign> signs;
  if (of_arc_e.enters && of_arc_f.leaves) signs.push_back(kernels::Sign::negative);
  if (of_arc_e.leaves && of_arc_f.enters) signs.push_back(kernels::Sign::positive);
  return signs;
}

}  // namespace

GaussianDiagram gaussian_diagram(const polytope::Polytope& polytope) { return diagram(polytope, Colour::b); }

GaussianDiagram gaussian_diagram_of_reflection(const polytope::Polytope& polytope) {
  return diagram(polytope, Colour::a);
}

kernels::Report validate(const GaussianDiagram& diagram, const polytope::Polytope& polytope, Colour colour) {
  const bool reflected = colour == Colour::a;
  kernels::Report report;
  const bool sizes = diagram.nodes.size() == polytope.facets.size() && diagram.arcs.size() == polytope.edges.size();
  if (!report.expect(diagram.rank == polytope.rank && sizes,
                     "the polytope's rank, one node a facet and one arc an edge"))
    return report;
  if (!report.expect(in_range(diagram, polytope), "nodes and faces of every arc exist, and a full circle has no nodes"))
    return report;
  for (const NodeId i : diagram.nodes.ids()) {
    const Vector& normal = polytope.facets[facet_of(i)].normal;
    report.expect(same_direction(reflected ? -normal : normal, diagram.nodes[i].exact()),
                  "node " + std::to_string(i.value) + " is not the normal of its facet");
  }
  const auto point = [&](VertexId v) { return reflected ? -polytope.vertices[v] : polytope.vertices[v]; };
  for (const ArcId i : diagram.arcs.ids()) {
    const Arc& arc = diagram.arcs[i];
    const std::string name = "arc " + std::to_string(i.value) + ": ";
    const Vector step = point(arc.above) - point(arc.below);
    report.expect(!is_zero(step) && same_direction(step, arc.circle.exact()),
                  name + "the face above is not the one on the circle's positive side");
    if (diagram.rank >= 2) check_ends(report, diagram, arc, step, name);
  }
  if (diagram.rank >= 2) report.expect(faces_close_up(diagram), "the arcs around a face do not close up");
  if (diagram.rank == 3) {
    report.expect(diagram.nodes.size() + polytope.vertices.size() == diagram.arcs.size() + 2,
                  "Euler's formula on the sphere");
  }
  return report;
}

std::vector<kernels::Sign> strict_crossings(const kernels::UnperturbedKernel& kernel, const GaussianDiagram& of_e,
                                            const Arc& e, const GaussianDiagram& of_f, const Arc& f) {
  // Two full circles may coincide; other arcs of one circle have a zero at an end.
  if (of_e.rank == 1 && of_f.rank == 1 && is_zero(cross(e.circle.exact(), f.circle.exact()))) return {};
  return crossings(kernel, of_e, e, of_f, f);
}

std::vector<kernels::Sign> perturbed_crossings(const kernels::PerturbedKernel& kernel, const GaussianDiagram& of_e,
                                               const Arc& e, const GaussianDiagram& of_f, const Arc& f) {
  return crossings(kernel, of_e, e, of_f, f);
}

bool contains(const GaussianDiagram& diagram, const Arc& arc, const Vector& u) {
  if (diagram.rank == 1) return true;
  const Vector& from = diagram.nodes[arc.from].exact();
  const Vector& to = diagram.nodes[arc.to].exact();
  // On an arc shorter than pi only its own directions pass both; on a half-circle the second
  // condition repeats the first.
  return det(from, u, arc.circle.exact()) >= 0 && det(u, to, arc.circle.exact()) >= 0;
}

bool touch(const GaussianDiagram& of_e, const Arc& e, const GaussianDiagram& of_f, const Arc& f) {
  const Vector w = cross(e.circle.exact(), f.circle.exact());
  if (!is_zero(w))
    return (contains(of_e, e, w) && contains(of_f, f, w)) || (contains(of_e, e, -w) && contains(of_f, f, -w));
  if (of_e.rank == 1 || of_f.rank == 1) return true;
  return contains(of_e, e, of_f.nodes[f.from].exact()) || contains(of_e, e, of_f.nodes[f.to].exact()) ||
         contains(of_f, f, of_e.nodes[e.from].exact()) || contains(of_f, f, of_e.nodes[e.to].exact());
}

}  // namespace fathom::gaussian
