// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/study/study.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "kernels/context.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/nearest.hpp"
#include "kernels/predicates/perturbation.hpp"
#include "kernels/predicates/perturbed_kernel.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::studies {

Feature StudiedBody::feature(gaussian::ArcId i) const {
  const polytope::Edge& edge = body.edges[i.value];
  const std::uint32_t p = body.input_ids[edge.from], q = body.input_ids[edge.to];
  return {std::min(p, q), std::max(p, q)};
}

Feature StudiedBody::feature(gaussian::NodeId i) const {
  const polytope::Facet& facet = body.facets[gaussian::facet_of(i)];
  Feature points;
  for (std::uint32_t k = facet.begin; k < facet.end; ++k) points.push_back(body.input_ids[body.corners[k]]);
  std::ranges::sort(points);
  return points;
}

Involved StudiedBody::involved(std::vector<Feature> own, std::vector<Feature> others) const {
  if (colour == gaussian::Colour::b) own.swap(others);
  return {std::move(own), std::move(others)};
}

namespace {

// ---- parallel edges and common normals: equal primitive vectors, found by sorting ----

/// The features with each of some directions.
template <class T>
using ByDirection = std::map<Vector, T, LexicographicOrder>;

/// Returns the one of u and -u whose first component other than zero is positive, made primitive:
/// it is equal for parallel vectors only.
Vector line_direction(const Vector& u) {
  Vector result = primitive(u);
  return lexicographically_less(result, Vector{0, 0, 0}) ? -result : result;
}

const polytope::Facet& facet_of(const StudiedBody& studied, gaussian::NodeId node) {
  return studied.body.facets[gaussian::facet_of(node)];
}

/// Returns whether two facets with parallel normals have the same supporting plane.
bool coplanar(const StudiedBodies& bodies, gaussian::NodeId of_a, gaussian::NodeId of_b) {
  const polytope::Polytope &a = bodies.a.body, &b = bodies.b.body;
  const polytope::Facet& facet = facet_of(bodies.a, of_a);
  return dot(facet.normal,
             a.vertices[a.corners[facet.begin]] - b.vertices[b.corners[facet_of(bodies.b, of_b).begin]]) == 0;
}

void find_parallel_edges(const StudiedBodies& bodies, Findings& findings) {
  ByDirection<gaussian::PerColour<std::vector<gaussian::ArcId>>> groups;
  for (const gaussian::Colour colour : gaussian::both_colours) {
    const gaussian::GaussianDiagram& diagram = bodies[colour].diagram;
    for (const gaussian::ArcId i : diagram.arcs.ids())
      groups[line_direction(diagram.arcs[i].circle.exact())][colour].push_back(i);
  }
  for (const auto& [direction, edges] : groups) {
    findings.add_pairs(Coincidence::parallel_edges, bodies, edges);
    findings.add_pairs(Coincidence::parallel_edges_of_a, bodies.a, edges.a);
    findings.add_pairs(Coincidence::parallel_edges_of_b, bodies.b, edges.b);
  }
}

// Facet normals are primitive, and no two facets of a body share one.
void find_common_normals(const StudiedBodies& bodies, Findings& findings) {
  const auto& [a, b] = bodies;
  ByDirection<gaussian::NodeId> facet_of_b;
  for (const gaussian::NodeId g : b.diagram.nodes.ids()) facet_of_b.emplace(facet_of(b, g).normal, g);
  for (const gaussian::NodeId f : a.diagram.nodes.ids()) {
    const Vector& normal = facet_of(a, f).normal;
    for (const bool equal : {false, true}) {
      const auto found = facet_of_b.find(equal ? normal : -normal);
      if (found == facet_of_b.end()) continue;
      const Involved facets{{a.feature(f)}, {b.feature(found->second)}};
      findings.add(equal ? Coincidence::equal_normals : Coincidence::coincident_normals, facets);
      if (coplanar(bodies, f, found->second)) findings.add(Coincidence::coplanar_facets, facets);
    }
  }
}

// ---- on the sphere ----

// Coincidences of the two Gaussian diagrams with each other and with the frame v = (0, 1, 0), z =
// (0, 0, 1).

/// Returns whether u, a direction on the arc's great circle, lies inside the arc, without its ends.
bool inside(const gaussian::GaussianDiagram& diagram, const gaussian::Arc& arc, const Vector& u) {
  if (diagram.rank == 1) return true;
  // On an arc shorter than pi only its own directions pass both; on a half-circle the second
  // condition repeats the first.
  return det(diagram.nodes[arc.from].exact(), u, arc.circle.exact()) > 0 &&
         det(u, diagram.nodes[arc.to].exact(), arc.circle.exact()) > 0;
}

bool on_equator(const gaussian::Arc& arc) { return arc.circle.exact().x == 0 && arc.circle.exact().y == 0; }

/// Returns the directions in which arcs of one diagram cross the equator, each with its arc. No two
/// are equal except for bodies of rank 1, whose one arc crosses twice, because arcs of a diagram do
/// not cross each other. With d = circle and z the pole, an arc that leaves z's side does so at d x
/// z: it continues along d x (d x z), which points downward.
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

void find_on_equator(const StudiedBody& studied, Findings& findings) {
  for (const gaussian::NodeId i : studied.diagram.nodes.ids())
    if (studied.diagram.nodes[i].exact().z == 0)
      findings.add(Coincidence::nodes_on_equator, studied.involved({studied.feature(i)}));
  for (const gaussian::ArcId i : studied.diagram.arcs.ids())
    if (on_equator(studied.diagram.arcs[i]))
      findings.add(Coincidence::arcs_on_equator, studied.involved({studied.feature(i)}));
}

/// Finds crossings of arcs of `lying`, which lie on the equator, with those of `passing` that cross
/// it.
void find_passages_through_arcs(const StudiedBody& lying, const StudiedBody& passing, Findings& findings) {
  const ByDirection<gaussian::ArcId> through = passages(passing.diagram);
  for (const gaussian::ArcId i : lying.diagram.arcs.ids()) {
    const gaussian::Arc& arc = lying.diagram.arcs[i];
    if (!on_equator(arc)) continue;
    for (const auto& [u, j] : through)
      if (inside(lying.diagram, arc, u))
        findings.add(Coincidence::crossings_on_equator, lying.involved({lying.feature(i)}, {passing.feature(j)}));
  }
}

void find_normals_on_arcs(kernels::Context& context, const StudiedBodies& bodies, Findings& findings) {
  const kernels::UnperturbedKernel kernel(context.counters.predicates);
  const double all = static_cast<double>(bodies.a.diagram.nodes.size() + bodies.b.diagram.nodes.size());
  std::size_t done = 0;
  for (const gaussian::Colour colour : gaussian::both_colours) {
    const StudiedBody &nodes = bodies[colour], &arcs = bodies[other(colour)];
    for (const gaussian::NodeId i : nodes.diagram.nodes.ids()) {
      context.report("normals on arcs", static_cast<double>(done++) / all);
      const kernels::Direction& node = nodes.diagram.nodes[i];
      for (const gaussian::ArcId j : arcs.diagram.arcs.ids()) {
        const gaussian::Arc& arc = arcs.diagram.arcs[j];
        if (kernel.side_of_arc(node, arc.circle) != kernels::Sign::zero || !inside(arcs.diagram, arc, node.exact()))
          continue;
        findings.add(Coincidence::normals_on_arcs, nodes.involved({nodes.feature(i)}, {arcs.feature(j)}));
      }
    }
  }
}

void find_equator_hits(const StudiedBodies& bodies, Findings& findings) {
  const auto& [a, b] = bodies;
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
void find_verticals(const StudiedBodies& bodies, Findings& findings) {
  ByDirection<gaussian::PerColour<std::vector<gaussian::NodeId>>> groups;
  for (const gaussian::Colour colour : gaussian::both_colours) {
    const StudiedBody& studied = bodies[colour];
    for (const gaussian::NodeId i : studied.diagram.nodes.ids()) {
      const Vector& n = studied.diagram.nodes[i].exact();
      if (n.z != 0) groups[primitive({n.x, 0, n.z})][colour].push_back(i);
    }
    for (const gaussian::ArcId i : studied.diagram.arcs.ids())
      if (studied.diagram.arcs[i].circle.exact().y == 0)
        findings.add(Coincidence::arcs_on_verticals, studied.involved({studied.feature(i)}));
  }
  for (const auto& [abscissa, nodes] : groups) {
    findings.add_pairs(Coincidence::nodes_on_one_vertical, bodies, nodes);
    findings.add_pairs(Coincidence::nodes_on_one_vertical, bodies.a, nodes.a);
    findings.add_pairs(Coincidence::nodes_on_one_vertical, bodies.b, nodes.b);
  }
}

// ---- the study ----

BodySize size_of(const polytope::Polytope& body) {
  return {body.rank, body.vertices.size(), body.edges.size(), body.facets.size()};
}

/// Returns the predicates that the topology of a pair calls, whether or not the bodies overlap.
PredicateCounts predicates_of(const gaussian::GaussianDiagram& minus_a, const gaussian::GaussianDiagram& b) {
  kernels::Context context;
  for (const chart::Hemisphere hemisphere : chart::both_hemispheres) {
    const chart::Charts charts = chart::make_charts(context, minus_a, b, chart::chart_frame(hemisphere));
    canonical::canonical_subsets(context, charts);
  }
  return context.counters.predicates;
}

/// The integer points of both bodies.
using Bodies = gaussian::PerColour<std::vector<Vector>>;

mpz_class common_divisor(const Bodies& bodies, mpz_class Vector::*axis) {
  mpz_class divisor;
  for (const gaussian::Colour colour : gaussian::both_colours) {
    for (const Vector& p : bodies[colour]) {
      mpz_gcd(divisor.get_mpz_t(), divisor.get_mpz_t(), (p.*axis).get_mpz_t());
      if (divisor == 1) return divisor;
    }
  }
  return divisor == 0 ? 1 : divisor;
}

/// Scales each axis by a unit of its own, and returns the units. Coincidences do not depend on
/// them, and bodies of 1 by 10^300 get short coordinates, on which filters can decide.
Vector stretch_axes(Bodies& bodies) {
  Vector units;
  for (mpz_class Vector::*axis : {&Vector::x, &Vector::y, &Vector::z}) {
    units.*axis = common_divisor(bodies, axis);
    for (const gaussian::Colour colour : gaussian::both_colours)
      for (Vector& p : bodies[colour])
        mpz_divexact((p.*axis).get_mpz_t(), (p.*axis).get_mpz_t(), (units.*axis).get_mpz_t());
  }
  return units;
}

/// Returns the face of a body in direction u.
Feature face(const polytope::Polytope& body, const Vector& u) {
  Feature points;
  const std::vector<std::uint32_t> extreme = kernels::extreme_points(kernels::PointCloud(body.vertices), u);
  for (const auto v : kernels::to_ids<polytope::VertexId>(extreme)) points.push_back(body.input_ids[v]);
  std::ranges::sort(points);
  return points;
}

void find_contacts(const StudiedBodies& bodies, const Vector& units, const Depth& depth, Findings& findings) {
  if (depth.touch()) {
    const Vector& n = depth.touch()->direction;
    const Vector u{n.x * units.x, n.y * units.y, n.z * units.z};
    findings.add(Coincidence::touching_features, {{face(bodies.a.body, -u)}, {face(bodies.b.body, u)}});
  }
  if (depth.optima().size() < 2) return;
  for (const Optimum& optimum : depth.optima())
    findings.add(Coincidence::ties, {{optimum.contact.a}, {optimum.contact.b}});
}

}  // namespace

std::uint64_t pairs_to_test(const StudiedBodies& bodies) {
  const auto &a = bodies.a.diagram, &b = bodies.b.diagram;
  return std::uint64_t{a.nodes.size()} * b.arcs.size() + std::uint64_t{b.nodes.size()} * a.arcs.size();
}

void find_coincidences(kernels::Context& context, const StudiedBodies& bodies, const Vector& units, const Depth& depth,
                       Findings& findings, std::uint64_t most_pairs) {
  context.report("coincidences");
  find_parallel_edges(bodies, findings);
  find_common_normals(bodies, findings);
  if (pairs_to_test(bodies) <= most_pairs) find_normals_on_arcs(context, bodies, findings);
  find_equator_hits(bodies, findings);
  find_verticals(bodies, findings);
  find_contacts(bodies, units, depth, findings);
}

Study study(kernels::Context& context, std::span<const Point> a, std::span<const Point> b,
            const StudyOptions& options) {
  Study result;
  result.depth = penetration_depth(a, b, {.method = Method::exact, .monitor = options.monitor});
  context.report("hulls");
  const polytope::PlacedPair placed = polytope::place(a, b);
  Bodies bodies{placed.a.points(), placed.b.points()};
  const Vector units = stretch_axes(bodies);
  const polytope::Polytope body_a = polytope::convex_hull(bodies.a), body_b = polytope::convex_hull(bodies.b);
  result.a = size_of(body_a);
  result.b = size_of(body_b);
  context.report("diagrams");
  const gaussian::GaussianDiagram diagram_a = gaussian::gaussian_diagram_of_reflection(body_a),
                                  diagram_b = gaussian::gaussian_diagram(body_b);
  result.predicates = result.depth.status() == Status::penetrating ? result.depth.counters.predicates
                                                                   : predicates_of(diagram_a, diagram_b);

  const StudiedBodies studied{{gaussian::Colour::a, body_a, diagram_a}, {gaussian::Colour::b, body_b, diagram_b}};
  Findings findings(result, options.listed);
  find_coincidences(context, studied, units, result.depth, findings);
  return result;
}

}  // namespace fathom::studies

namespace fathom {

Study study(std::span<const Point> a, std::span<const Point> b, const StudyOptions& options) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(options.monitor);
  return studies::study(context, a, b, options);
}

std::string monomial_name(std::uint64_t packed) {
  constexpr std::array<std::string_view, kernels::infinitesimals> names{"E11", "E12", "E13", "E21", "E22", "E23",
                                                                        "E31", "E32", "E33", "a",   "b",   "c"};
  const kernels::Monomial monomial = kernels::Monomial::unpacked(packed);
  const kernels::Perturbation perturbation;
  std::string result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const unsigned exponent = monomial.exponent(perturbation.rank[i]);
    if (exponent == 0) continue;
    if (!result.empty()) result += ' ';
    result += names[i];
    if (exponent > 1) result.append("^").append(std::to_string(exponent));
  }
  return result.empty() ? "1" : result;
}

}  // namespace fathom
