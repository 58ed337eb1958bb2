// SPDX-License-Identifier: GPL-3.0-or-later
// Ways of breaking general position that turn a feature of a body until it coincides with another one, or with the chart's frame.
#include <algorithm>

#include "kernels/vector.hpp"
#include "verify/families/alignment.hpp"
#include "verify/families/degrade_ways.hpp"

namespace fathom::families {

namespace {

constexpr std::size_t window = 24;  // at most this many features of a body are searched, since pairs of them are compared

const Point pole{0, 0, 1}, upright{0, 1, 0};

bool is_origin(const Point& p) { return p.x == 0 && p.y == 0 && p.z == 0; }

/// `window` successive members from a random place on; all of a short list, in another order.
template <class T>
std::vector<T> some(std::vector<T> list, Random& random) {
  if (list.empty()) return list;
  const auto start = random.between(0, static_cast<std::int64_t>(list.size()) - 1);
  std::rotate(list.begin(), list.begin() + start, list.end());
  list.resize(std::min(list.size(), window));
  return list;
}

std::vector<Point> with_negatives(std::vector<Point> list) {
  for (std::size_t i = 0, given = list.size(); i < given; ++i) {
    const Point p = list[i];
    list.push_back(-p);
  }
  return list;
}

std::vector<Point> negated(const std::vector<Point>& list) {
  std::vector<Point> result;
  for (const Point& p : list) result.push_back(-p);
  return result;
}

/// A direction and where it is to point.
struct Turn {
  Point from, to;
};

/// Returns the direction that is closest to its target, or nullopt if no target is in reach.
template <class Target>
std::optional<Turn> smallest_turn(const std::vector<Point>& directions, Target target) {
  std::optional<Turn> best;
  mpq_class most = 0;
  for (const Point& from : directions) {
    const Point to = target(from);
    if (is_origin(to)) continue;
    if (const mpq_class here = agreement(from, to); here > most) {
      most = here;
      best = Turn{from, to};
    }
  }
  return best;
}

/// A pair of directions of A and of B, as a turn of A's.
std::optional<Turn> smallest_turn(const std::vector<Point>& of_a, const std::vector<Point>& of_b) {
  const auto best = best_agreement(of_a, of_b);
  if (!best) return std::nullopt;
  return Turn{of_a[best->first], of_b[best->second]};
}

template <class Target>
void turn_normals(Bodies& bodies, Random& random, Target target) {
  for (Body* body : {&bodies.a, &bodies.b})
    if (const auto turn = smallest_turn(some(features(*body).normals, random), target)) *body = normal_aligned(*body, turn->from, turn->to);
}

template <class Target>
void turn_edges(Bodies& bodies, Random& random, Target target) {
  for (Body* body : {&bodies.a, &bodies.b})
    if (const auto turn = smallest_turn(some(features(*body).edge_directions, random), target))
      *body = edge_aligned(*body, turn->from, turn->to);
}

/// Turns A, and returns B's direction.
std::optional<Point> turn_normal_of_a(Bodies& bodies, const std::vector<Point>& of_a, const std::vector<Point>& of_b) {
  const auto turn = smallest_turn(of_a, of_b);
  if (!turn) return std::nullopt;
  bodies.a = normal_aligned(bodies.a, turn->from, turn->to);
  return turn->to;
}

std::vector<Point> normals(const Body& body, Random& random) { return some(features(body).normals, random); }

mpq_class reach(const Body& body, const Point& u) {
  mpq_class most = dot(u, body.points.front());
  for (const Point& p : body.points) most = std::max(most, dot(u, p));
  return most;
}

/// The axis nearest to p, with its sign.
Point nearest_axis(const Point& p) {
  const mpq_class x = abs(p.x), y = abs(p.y), z = abs(p.z);
  if (x >= y && x >= z) return {sgn(p.x), 0, 0};
  return y >= z ? Point{0, sgn(p.y), 0} : Point{0, 0, sgn(p.z)};
}

}  // namespace

void shared_vertex(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = some(features(bodies.a).vertices, random), of_b = some(features(bodies.b).vertices, random);
  bodies.a = translated(bodies.a, of_b.front() - of_a.front());
}

void shared_edge_direction(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = some(features(bodies.a).edge_directions, random);
  const std::vector<Point> of_b = with_negatives(some(features(bodies.b).edge_directions, random));
  if (const auto turn = smallest_turn(of_a, of_b)) bodies.a = edge_aligned(bodies.a, turn->from, turn->to);
}

void shared_facet_normal(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random), of_b = normals(bodies.b, random);
  turn_normal_of_a(bodies, of_a, of_b);
}

void opposite_facet_normals(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random), of_b = negated(normals(bodies.b, random));
  turn_normal_of_a(bodies, of_a, of_b);
}

void coplanar_facets(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random), of_b = normals(bodies.b, random);
  const std::optional<Point> normal = turn_normal_of_a(bodies, of_a, of_b);
  if (!normal) return;
  const mpq_class missing = reach(bodies.b, *normal) - reach(bodies.a, *normal);
  bodies.a = translated(bodies.a, (missing / dot(*normal, *normal)) * (*normal));
}

void axis_aligned_facet(Bodies& bodies, Random& random) { turn_normals(bodies, random, nearest_axis); }

void normal_at_pole(Bodies& bodies, Random& random) {
  turn_normals(bodies, random, [](const Point& n) { return along(n, pole); });
}

void normal_on_equator(Bodies& bodies, Random& random) {
  turn_normals(bodies, random, [](const Point& n) { return across(n, pole); });
}

void arc_on_equator(Bodies& bodies, Random& random) {
  turn_edges(bodies, random, [](const Point& d) { return along(d, pole); });
}

void vertical_edge(Bodies& bodies, Random& random) {
  turn_edges(bodies, random, [](const Point& d) { return across(d, upright); });
}

// The great circle through v and a node m of B has the normal m x v; -A's node -n lies on it if n does.
void nodes_on_one_vertical(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random);
  std::optional<Turn> best;
  for (const Point& m : normals(bodies.b, random)) {
    const Point circle = cross(m, upright);
    if (is_origin(circle)) continue;
    const auto turn = smallest_turn(of_a, [&](const Point& n) { return across(n, circle); });
    if (turn && (!best || agreement(turn->from, turn->to) > agreement(best->from, best->to))) best = turn;
  }
  if (best) bodies.a = normal_aligned(bodies.a, best->from, best->to);
}

void normal_on_arc(Bodies& bodies, Random& random) {
  const std::vector<Point> of_a = normals(bodies.a, random);
  std::vector<Point> middles;
  for (const auto& [left, right] : some(features(bodies.b).arcs, random)) middles.push_back(-left - right);
  turn_normal_of_a(bodies, of_a, middles);
}

}  // namespace fathom::families
