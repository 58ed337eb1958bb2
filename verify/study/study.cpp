// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/study/study.hpp"

#include <algorithm>
#include <array>

#include "kernels/context.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/predicates/perturbation.hpp"
#include "reference/canonical/canonical_subsets.hpp"
#include "reference/chart/chart.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::studies {
namespace {

BodySize size_of(const polytope::Polytope& body) { return {body.rank, body.vertices.size(), body.edges.size(), body.facets.size()}; }

/// The predicates that the topology of a pair calls, whether or not the bodies overlap.
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

/// Gives each axis a unit of its own, and returns the units. No coincidence depends on them, and bodies of 1 by 10^300 get short
/// coordinates, on which filters decide.
Vector stretch_axes(Bodies& bodies) {
  Vector units;
  for (mpz_class Vector::*axis : {&Vector::x, &Vector::y, &Vector::z}) {
    units.*axis = common_divisor(bodies, axis);
    for (const gaussian::Colour colour : gaussian::both_colours)
      for (Vector& p : bodies[colour]) mpz_divexact((p.*axis).get_mpz_t(), (p.*axis).get_mpz_t(), (units.*axis).get_mpz_t());
  }
  return units;
}

/// The face of a body in direction u.
Feature face(const polytope::Polytope& body, const Vector& u) {
  Feature points;
  const std::vector<std::uint32_t> extreme = kernels::extreme_points(kernels::PointCloud(body.vertices), u);
  for (const auto v : kernels::to_ids<polytope::VertexId>(extreme)) points.push_back(body.input_ids[v]);
  std::ranges::sort(points);
  return points;
}

void find_contacts(const polytope::Polytope& a, const polytope::Polytope& b, const Vector& units, const Depth& depth, Findings& findings) {
  if (depth.touch()) {
    const Vector& n = depth.touch()->direction;
    const Vector u{n.x * units.x, n.y * units.y, n.z * units.z};
    findings.add(Coincidence::touching_features, {{face(a, -u)}, {face(b, u)}});
  }
  if (depth.optima().size() < 2) return;
  for (const Optimum& optimum : depth.optima()) findings.add(Coincidence::ties, {{optimum.contact.a}, {optimum.contact.b}});
}

}  // namespace

Study study(kernels::Context& context, std::span<const Point> a, std::span<const Point> b, const StudyOptions& options) {
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
  result.predicates = result.depth.status() == Status::penetrating ? result.depth.counters.predicates : predicates_of(diagram_a, diagram_b);

  context.report("coincidences");
  const Subjects subjects{{gaussian::Colour::a, body_a, diagram_a}, {gaussian::Colour::b, body_b, diagram_b}};
  Findings findings(result, options.listed);
  find_parallel_edges(subjects, findings);
  find_common_normals(subjects, findings);
  find_normals_on_arcs(context, subjects, findings);
  find_equator_hits(subjects, findings);
  find_verticals(subjects, findings);
  find_contacts(body_a, body_b, units, result.depth, findings);
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
