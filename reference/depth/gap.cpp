// SPDX-License-Identifier: GPL-3.0-or-later
// The next nearest facet of P either shares an edge with a nearest one, or holds the foot point of
// O in its interior. The first kind is found by turning the plane of each nearest facet about its
// edges, the second by an expanding polytope.                              [proofs/gap.md, lemma 1]
#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/expanding/expander.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::depth {
namespace {

template <class Integer>
using Vectors = std::vector<Vec3<Integer>>;

// The directions of the edges of a face with these extreme points, counter-clockwise seen against
// n; a segment has two: there and back.
template <class Integer>
Vectors<Integer> edge_directions(const Vectors<Integer>& points, const Vec3<Integer>& n) {
  if (points.size() == 1) return {};
  std::vector<std::uint32_t> cycle(points.size());
  std::iota(cycle.begin(), cycle.end(), 0U);
  cycle = polytope::polygon_corners(points, std::move(cycle), n);
  Vectors<Integer> directions;
  for (std::size_t i = 0; i < cycle.size(); ++i)
    directions.push_back(points[cycle[(i + 1) % cycle.size()]] - points[cycle[i]]);
  return directions;
}

// The one of the points that is farthest in direction u.
template <class Integer>
std::size_t extreme(const Vectors<Integer>& points, const Vec3<Integer>& u) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (sgn(dot(u, points[i] - points[best])) > 0) best = i;
  return best;
}

// The squared distance of the plane <normal, x> = <normal, p>.
template <class Integer>
mpq_class squared_distance(const Vec3<Integer>& normal, const Vec3<Integer>& p) {
  const Integer height = dot(normal, p);
  return kernels::ratio(expanding::to_mpz(Integer(height * height)), expanding::to_mpz(dot(normal, normal)));
}

// The normal of the facet beyond the edge of the facet with normal n that runs through p along d,
// counter-clockwise seen from outside: the first plane about the edge, turned away from n, that has
// no point of P above it. Every step turns farther back.
template <class Differences, class Integer>
Vec3<Integer> normal_beyond(Differences& differences, const Vec3<Integer>& n, const Vec3<Integer>& p,
                            const Vec3<Integer>& d) {
  Vec3<Integer> normal = cross(differences[differences.extreme(-n)] - p, d);
  for (;;) {
    const Vec3<Integer> highest = differences[differences.extreme(normal)] - p;
    if (sgn(dot(normal, highest)) <= 0) return normal;
    normal = cross(highest, d);
  }
}

// The least squared distance, other than `nearest`, of the facets that share an edge with the
// nearest facet `optimum`.
template <class Differences>
void look_around(Differences& differences, const Optimum& optimum, const mpq_class& nearest,
                 std::optional<mpq_class>& least) {
  using Integer = typename Differences::Integer;
  const auto& [n_x, n_y, n_z] = optimum.direction;
  const Vec3<Integer> n{Integer(n_x), Integer(n_y), Integer(n_z)};
  const std::vector<std::uint32_t>&of_a = optimum.contact.a, &of_b = optimum.contact.b;
  Vectors<Integer> minus_a, b;  // each with the first corner of the other face added
  for (const std::uint32_t i : of_a) minus_a.push_back(differences[{i, of_b.front()}]);
  for (const std::uint32_t i : of_b) b.push_back(differences[{of_a.front(), i}]);
  for (const Vectors<Integer>* face : {&minus_a, &b}) {
    for (const Vec3<Integer>& d : edge_directions(*face, n)) {
      const Vec3<Integer> outwards = cross(d, n),
                          p = differences[{of_a[extreme(minus_a, outwards)], of_b[extreme(b, outwards)]}];
      const mpq_class squared = squared_distance(normal_beyond(differences, n, p, d), p);
      if (squared != nearest && (!least || squared < *least)) least = squared;
    }
  }
}

// The answer on one lattice: all neighbours, and then what an expansion finds that is nearer than
// those. Returns nullopt if its integers are too short for it.
template <class Integer>
std::optional<std::optional<mpq_class>> second_nearest(kernels::Context& context,
                                                       const polytope::PlacedPairIn<Integer>& pair,
                                                       const Penetration& penetration, Workspace& workspace) {
  const mpq_class unit = pair.unit(), square = unit * unit, nearest = penetration.squared() / square;
  std::optional<mpq_class> least;
  auto differences = pair.differences();
  for (const Optimum& optimum : penetration.optima) look_around(differences, optimum, nearest, least);
  if (!least) return std::optional<mpq_class>();  // without one, whatever can be reached from a nearest facet is one
  const std::optional<mpq_class> next = expanding::next_nearest_by_expansion(context, pair, nearest, *least, workspace);
  if (!next) return std::nullopt;
  return std::optional<mpq_class>(*next * square);
}

std::optional<mpq_class> second_nearest_of(const polytope::Points& a, const polytope::Points& b,
                                           const Penetration& penetration, Monitor* monitor, Workspace* workspace) {
  const kernels::DefaultFloatEnvironment environment;
  if (penetration.unlisted > 0)
    throw std::invalid_argument("the second nearest facet is looked for from all optima, and some are not listed");
  kernels::Context context(monitor);
  std::optional<Workspace> own;
  if (workspace == nullptr) workspace = &own.emplace();
  Workspace::Parts& parts = *workspace->parts;
  if (polytope::place_narrow(a, b, parts.placed)) {
    const auto pair = parts.placed.pair<polytope::NarrowInteger>(a, b, parts.scan);
    if (auto found = second_nearest(context, pair, penetration, *workspace)) return std::move(*found);
  }
  std::vector<Point> room_a, room_b;
  return *second_nearest(context, polytope::place(a.exact(room_a), b.exact(room_b)), penetration, *workspace);
}

}  // namespace

}  // namespace fathom::depth

namespace fathom {

std::optional<mpq_class> second_nearest_squared(std::span<const Point> a, std::span<const Point> b,
                                                const Penetration& penetration, Monitor* monitor,
                                                Workspace* workspace) {
  return depth::second_nearest_of(a, b, penetration, monitor, workspace);
}

std::optional<mpq_class> second_nearest_squared(const Body& a, const Body& b, const Penetration& penetration,
                                                Monitor* monitor, Workspace* workspace) {
  return depth::second_nearest_of(a.points, b.points, penetration, monitor, workspace);
}

}  // namespace fathom
