// SPDX-License-Identifier: GPL-3.0-or-later
// With p in the middle of the edge, O goes to p - x, where x = s n1 + t n2 has the heights that are wanted over both planes.
#include <algorithm>
#include <optional>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/filters/support.hpp"
#include "reference/approximate/shallow_surface.hpp"
#include "reference/polytope/lattice.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

/// An edge of P, half way between its ends, and the normals of the facets beside it.
struct Ridge {
  Vector twice_middle, left, right;
};

const approximate::SumEdge& any(const std::vector<approximate::SumEdge>& edges, Random& random) {
  return edges[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(edges.size()) - 1))];
}

std::vector<polytope::VertexId> extreme_face(const polytope::Polytope& p, const Vector& u) {
  return kernels::to_ids<polytope::VertexId>(kernels::extreme_points(kernels::PointCloud(p.vertices), u));
}

/// After a few steps from a facet of B against a vertex of A.
Ridge any_ridge(const polytope::Polytope& a, const polytope::Polytope& b, Random& random) {
  const approximate::SumSurface surface(a, b);
  const Vector n = b.facets.at(static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(b.facets.size()) - 1))).normal;
  approximate::SumFacet facet = surface.facet(extreme_face(a, -n), extreme_face(b, n), n);
  std::uint64_t steps = 0;
  for (int i = 0; i < 8; ++i) {
    const std::vector<approximate::SumEdge> edges = surface.edges(facet);
    facet = surface.across(any(edges, random), &steps);
  }
  const std::vector<approximate::SumEdge> edges = surface.edges(facet);
  const approximate::SumEdge& edge = any(edges, random);
  return {surface.from(edge) + surface.to(edge), facet.normal, surface.across(edge, &steps).normal};
}

/// x with <left, x> = on_left and <right, x> = on_right, in the plane of both normals, rounded to multiples of 2^-bits.
Point between(const Ridge& ridge, const mpq_class& on_left, const mpq_class& on_right, long bits) {
  const mpq_class left(dot(ridge.left, ridge.left)), right(dot(ridge.right, ridge.right)), mixed(dot(ridge.left, ridge.right));
  const mpq_class divisor = left * right - mixed * mixed;
  const mpq_class s = (on_left * right - on_right * mixed) / divisor, t = (on_right * left - on_left * mixed) / divisor;
  const auto component = [&](const mpz_class& l, const mpz_class& r) {
    const mpq_class scaled_up = times_power_of_two(mpq_class(s * l + t * r), bits);
    return times_power_of_two(mpq_class(mpz_class(scaled_up.get_num() / scaled_up.get_den())), -bits);
  };
  return {component(ridge.left.x, ridge.right.x), component(ridge.left.y, ridge.right.y), component(ridge.left.z, ridge.right.z)};
}

/// Whether the left facet is the nearest one, and the next one farther by the factor 1 + 2^-k, nearly.
bool as_planned(const Bodies& bodies, const Ridge& ridge, long k) {
  const Depth depth = penetration_depth(bodies.a.points, bodies.b.points);
  const auto* found = std::get_if<Penetration>(&depth.outcome);
  if (!found || found->optima.size() != 1 || found->optima.front().direction != ridge.left) return false;
  const std::optional<mpq_class> next = second_nearest_squared(bodies.a.points, bodies.b.points, *found);
  if (!next) return false;
  const mpq_class gap = quotient_of_roots(*next, found->squared(), k + 24) - 1;
  return abs(mpq_class(times_power_of_two(gap, k) - 1)) < ratio(1, 1 << 17);
}

}  // namespace

Bodies inverse_ridge(Random& random, unsigned n) {
  const Body a = random_sphere_body(random, std::max(4u, n)), b = random_sphere_body(random, std::max(4u, n));
  const long k = random.between(8, 200);
  const polytope::PlacedPair pair = polytope::place(a.points, b.points);
  const polytope::Polytope hull_a = polytope::convex_hull(pair.a.points()), hull_b = polytope::convex_hull(pair.b.points());
  for (long closer = 3; closer < 24 && hull_a.rank == 3 && hull_b.rank == 3; ++closer) {
    const Ridge ridge = any_ridge(hull_a, hull_b, random);
    const mpq_class left_squared(dot(ridge.left, ridge.left)), right_squared(dot(ridge.right, ridge.right));
    const mpq_class distance = times_power_of_two(mpq_class(pair.denominator), -closer);  // radii are 1
    const long bits = k + 40 + closer;
    const mpq_class on_left = distance * quotient_of_roots(left_squared, 1, bits);
    const mpq_class on_right = distance * (1 + times_power_of_two(1, -k)) * quotient_of_roots(right_squared, 1, bits);
    const Point x = between(ridge, on_left, on_right, bits);
    const auto shift = [&](const mpq_class& from_middle, const mpz_class& twice_middle) {
      return mpq_class((from_middle - ratio(twice_middle, 2)) / mpq_class(pair.denominator));
    };
    Bodies result{a, translated(b, {shift(x.x, ridge.twice_middle.x), shift(x.y, ridge.twice_middle.y), shift(x.z, ridge.twice_middle.z)})};
    if (as_planned(result, ridge, k)) return result;
  }
  return {a, b};
}

}  // namespace fathom::families
