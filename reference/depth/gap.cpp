// SPDX-License-Identifier: GPL-3.0-or-later
// The next nearest facet of P either shares an edge with a nearest one, or holds the foot point of O in its interior. The first kind is
// found by turning the plane of each nearest facet about its edges, the second by an expanding polytope.       [proofs/gap.md, lemma 1]
#include "reference/depth/gap.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "kernels/float_environment.hpp"
#include "kernels/number/ratio.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/differences.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::depth {
namespace {

// The directions of the edges of a face with these extreme points, counter-clockwise seen against n; a segment has two: there and back.
std::vector<Vector> edge_directions(const std::vector<Vector>& points, const Vector& n) {
  if (points.size() == 1) return {};
  if (points.size() == 2) return {points[1] - points[0], points[0] - points[1]};
  const polytope::Polytope face = polytope::convex_hull(points);
  const bool reversed = dot(face.facets.front().normal, n) < 0;
  std::vector<Vector> directions;
  directions.reserve(face.edges.size());
  for (const polytope::Edge& edge : face.edges) {
    const Vector along = face.vertices[edge.to] - face.vertices[edge.from];
    directions.push_back(reversed ? -along : along);
  }
  return directions;
}

const Vector& extreme(const std::vector<Vector>& points, const Vector& u) {
  return *std::ranges::max_element(points, {}, [&u](const Vector& p) { return dot(u, p); });
}

// The squared distance of the plane <normal, x> = <normal, p>.
mpq_class squared_distance(const Vector& normal, const Vector& p) {
  const mpz_class height = dot(normal, p);
  return kernels::ratio(height * height, dot(normal, normal));
}

// The normal of the facet beyond the edge of the facet with normal n that runs through p along d, counter-clockwise seen from outside: the
// first plane about the edge, turned away from n, that has no point of P above it. Every step turns farther back.
Vector normal_beyond(polytope::Differences& differences, const Vector& n, const Vector& p, const Vector& d) {
  Vector normal = cross(differences[differences.extreme(-n)] - p, d);
  for (;;) {
    const Vector highest = differences[differences.extreme(normal)] - p;
    if (dot(normal, highest) <= 0) return normal;
    normal = cross(highest, d);
  }
}

// The least squared distance, other than `nearest`, of the facets that share an edge with the nearest facet `optimum`.
void look_around(polytope::Differences& differences, const Optimum& optimum, const mpq_class& nearest, std::optional<mpq_class>& least) {
  const Vector& n = optimum.direction;
  std::vector<Vector> minus_a, b;
  for (const std::uint32_t i : optimum.contact.a) minus_a.push_back(-differences.a[i]);
  for (const std::uint32_t i : optimum.contact.b) b.push_back(differences.b[i]);
  for (const std::vector<Vector>* face : {&minus_a, &b}) {
    for (const Vector& d : edge_directions(*face, n)) {
      const Vector outwards = cross(d, n), p = extreme(minus_a, outwards) + extreme(b, outwards);
      const mpq_class squared = squared_distance(normal_beyond(differences, n, p, d), p);
      if (squared != nearest && (!least || squared < *least)) least = squared;
    }
  }
}

}  // namespace

std::optional<mpq_class> second_nearest_squared_naive(std::span<const Point> a, std::span<const Point> b) {
  const kernels::DefaultFloatEnvironment environment;
  const polytope::PlacedPair pair = polytope::place(a, b);
  const polytope::Polytope hull_a = polytope::convex_hull(pair.a.points()), hull_b = polytope::convex_hull(pair.b.points());
  std::vector<Vector> differences;
  for (const Vector& p : hull_a.vertices)
    for (const Vector& q : hull_b.vertices) differences.push_back(q - p);
  const polytope::Polytope p = polytope::convex_hull(differences);
  std::vector<mpq_class> squares;
  for (const polytope::Facet& facet : p.facets) {
    const Vector& corner = p.vertices[p.corners[facet.begin]];
    if (p.rank < 3 || dot(facet.normal, corner) <= 0) throw std::invalid_argument("only bodies that penetrate have a next nearest facet");
    squares.push_back(squared_distance(facet.normal, corner));
  }
  if (squares.empty()) throw std::invalid_argument("only bodies that penetrate have a next nearest facet");
  std::ranges::sort(squares);
  const auto next = std::ranges::upper_bound(squares, squares.front());
  if (next == squares.end()) return std::nullopt;
  return mpq_class(*next / mpq_class(pair.denominator * pair.denominator));
}

}  // namespace fathom::depth

namespace fathom {

std::optional<mpq_class> second_nearest_squared(std::span<const Point> a, std::span<const Point> b, const Penetration& penetration,
                                                Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  if (penetration.unlisted > 0)
    throw std::invalid_argument("the second nearest facet is looked for from all optima, and some are not listed");
  kernels::Context context(monitor);
  const polytope::PlacedPair pair = polytope::place(a, b);
  const mpq_class unit(pair.denominator * pair.denominator), nearest = penetration.squared() * unit;
  polytope::Differences differences{pair.a, pair.b};
  std::optional<mpq_class> least;
  for (const Optimum& optimum : penetration.optima) depth::look_around(differences, optimum, nearest, least);
  if (!least) return std::nullopt;  // whatever can be reached from a nearest facet is one
  return mpq_class(expanding::next_nearest_by_expansion(context, pair.a, pair.b, nearest, *least) / unit);
}

}  // namespace fathom
