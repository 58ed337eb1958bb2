// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/shallow.hpp"

#include <set>
#include <stdexcept>
#include <vector>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/contact.hpp"

namespace fathom::approximate {
namespace {

const mpq_class& checked(const mpq_class& delta) {
  kernels::require_lowest_terms(delta);
  if (delta <= 0 || delta > 2) throw std::invalid_argument("shallow penetration needs a delta with 0 < delta <= 2");
  return delta;
}

/// The facets that the rays hit, each once.
std::vector<SumFacet> facets_hit(const std::vector<NearRay>& rays, const SumSurface& surface, const polytope::Hierarchy& a,
                                 const polytope::Hierarchy& b) {
  std::set<Vector, kernels::NearestPlanes::LexicographicOrder> normals;
  for (const NearRay& ray : rays) normals.insert(ray.normal);
  std::vector<SumFacet> facets;
  for (const Vector& n : normals) facets.push_back(surface.facet(a.extreme_face(-n), b.extreme_face(n), n));
  return facets;
}

/// Whether the sum of the faces with these vertices, which lie in parallel planes, is two-dimensional.
bool span_a_facet(const polytope::Polytope& a, const std::vector<polytope::VertexId>& face_a, const polytope::Polytope& b,
                  const std::vector<polytope::VertexId>& face_b) {
  if (face_a.size() > 2 || face_b.size() > 2) return true;
  if (face_a.size() < 2 || face_b.size() < 2) return false;
  return !is_zero(cross(a.vertices[face_a[1]] - a.vertices[face_a[0]], b.vertices[face_b[1]] - b.vertices[face_b[0]]));
}

}  // namespace

ShallowPenetration::ShallowPenetration(kernels::Context& context, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                                       const mpq_class& delta)
    : a_(&a), b_(&b), shooter_(a, b), surface_(a.polytope(), b.polytope()), delta_(checked(delta)), grids_(context, delta / 4) {}

ShallowResult ShallowPenetration::query(kernels::Context& context, const Vector& shift) const {
  const kernels::DefaultFloatEnvironment environment;
  ShallowResult result;
  if (shooter_.rank() < 3) return result;
  const NearRays rays = grids_.shoot(context, shooter_, shift);
  result.inside = rays.inside;
  result.rays = rays.rays;
  result.rays_skipped = rays.skipped;
  result.ray_steps = rays.steps;
  if (!rays.inside) return result;
  const mpq_class factor = 1 + delta_ / 2;
  result.ball_radius_squared = factor * factor * rays.nearest_squared;
  const Ball ball{shift, result.ball_radius_squared.get_num(), result.ball_radius_squared.get_den()};
  const std::vector<SumFacet> starts = facets_hit(rays.in_reach, surface_, *a_, *b_);
  result.starts = starts.size();
  const WalkCounts counts = walk(context, surface_, ball, starts, [&](const SumFacet& facet) {
    result.nearest.offer(facet.normal, dot(facet.normal, surface_.point(facet) - shift));
  });
  result.facets = counts.facets;
  result.edges = counts.edges;
  result.walk_steps = counts.steps;
  return result;
}

kernels::Report validate(const ShallowResult& result, const polytope::Hierarchy& a, const polytope::Hierarchy& b, const Vector& shift) {
  kernels::Report report;
  report.expect(result.inside != result.nearest.empty(), "nearest planes exactly if O is inside P");
  const polytope::Polytope &hull_a = a.polytope(), &hull_b = b.polytope();
  for (const Vector& n : result.nearest.directions()) {
    const std::vector<polytope::VertexId> face_a = a.extreme_face(-n), face_b = b.extreme_face(n);
    report.expect(span_a_facet(hull_a, face_a, hull_b, face_b), "a nearest direction is not that of a facet");
    const mpz_class height = dot(n, hull_b.vertices[face_b.front()] - hull_a.vertices[face_a.front()] - shift);
    report.expect(height > 0 && height * height * result.nearest.denominator() == result.nearest.numerator() * dot(n, n),
                  "a nearest facet is at another distance");
  }
  return report;
}

}  // namespace fathom::approximate

namespace fathom {

Depth shallow_depth(std::span<const Point> a, std::span<const Point> b, const Options& options, const mpq_class& delta) {
  const kernels::DefaultFloatEnvironment environment;
  approximate::checked(delta);
  depth::require_listed(options.optima);
  kernels::Context context(options.monitor);
  const polytope::PlacedPair pair = polytope::place(a, b);
  depth::Beginning made{.pair = &pair};
  if (depth::begin(context, made, options.validate)) {
    context.report("hierarchies");
    const polytope::Hierarchy hierarchy_a(made.hulls.a), hierarchy_b(made.hulls.b);
    const approximate::ShallowPenetration bodies(context, hierarchy_a, hierarchy_b, delta);
    const approximate::ShallowResult found = bodies.query(context);
    if (!found.inside) throw std::logic_error("O is inside P, and a ray from it found otherwise");
    if (options.validate) kernels::insist(approximate::validate(found, hierarchy_a, hierarchy_b));
    context.counters.rays = found.rays;
    context.counters.facets_visited = found.facets;
    made.depth.outcome = depth::penetration_along(pair, found.nearest.directions(), options.optima);
  }
  made.depth.counters = context.counters;
  return std::move(made.depth);
}

}  // namespace fathom
