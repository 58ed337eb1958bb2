// SPDX-License-Identifier: GPL-3.0-or-later
// A face of a body is the hull of the body's extreme points in a direction, so contacts need the hulls of a few faces only.
#include "reference/depth/certified_depth.hpp"

#include <algorithm>

#include "reference/depth/contact.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom {
namespace {

// The face of a body in direction u, as a polytope; ids are those of the input.
Polytope face(const PointCloud& body, const Vector& u) {
  const std::vector<std::uint32_t> extreme = extreme_points(body, u);
  std::vector<Vector> points;
  points.reserve(extreme.size());
  for (const std::uint32_t i : extreme) points.push_back(body[i]);
  Polytope hull = convex_hull(points);
  for (std::uint32_t& id : hull.input_ids) id = extreme[id];
  return hull;
}

struct Faces {
  Polytope a, b;
  Bodies bodies;

  Faces(const Lattice& lattice, const PointCloud& of_a, const PointCloud& of_b, const Vector& n)
      : a(face(of_a, -n)),
        b(face(of_b, n)),
        bodies{lattice, a, b, PointCloud(a.vertices, of_a.exponent()), PointCloud(b.vertices, of_b.exponent())} {}
};

}  // namespace

std::optional<Depth> certified_depth(const Lattice& lattice, const PointCloud& a, const PointCloud& b, const Options& options) {
  ExpansionOptions limits;
  limits.most_points = options.expansion_budget.value_or(std::min<std::size_t>(200 + 2 * (a.size() + b.size()), 20000));
  limits.on_step = [&options] {
    if (options.progress && !options.progress("expanding polytope", 0)) throw Interrupted();
  };
  Expansion expansion = nearest_by_expansion(a, b, limits);
  if (expansion.end != ExpansionEnd::proved) return std::nullopt;
  if (options.validate) insist(validate(expansion, a, b));

  Depth result;
  result.status = Status::penetrating;
  result.method = Method::certificate;
  result.flat_a = affine_rank(lattice.a) < 3;
  result.flat_b = affine_rank(lattice.b) < 3;
  for (const Vector& n : expansion.nearest.directions()) {
    const Faces faces(lattice, a, b, n);
    result.optima.push_back(optimum(faces.bodies, n));
    if (!result.witness) result.witness = witness(faces.bodies, result.optima.front());
  }
  const Optimum& first = result.optima.front();
  result.direction = first.direction;
  result.translation = first.translation;
  result.contact = first.contact;
  const Point& t = first.translation;
  result.squared = t.x * t.x + t.y * t.y + t.z * t.z;
  result.counters.expansions = expansion.points;
  result.counters.inner_facets = expansion.inner.facets.size();
  result.inner = std::move(expansion.inner);
  return result;
}

}  // namespace fathom
