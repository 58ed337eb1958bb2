// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/nightly/unions_by_parts.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <tuple>
#include <utility>

#include "fathom/union.hpp"
#include "reference/polytope/polytope.hpp"
#include "tests/unions/naive_union.hpp"

namespace fathom::nightly {
namespace {

using harness::UnionsFound;
using Solid = std::vector<Point>;

constexpr std::size_t most_planes = 100;  // 160 thousand triples

Depth exact_depth(const Solid& a, const Solid& b, Monitor* monitor) {
  Options options;
  options.method = Method::exact;
  options.monitor = monitor;
  return penetration_depth(a, b, options);
}

/// Whether the boxes around them have a common interior.
bool boxes_overlap(const Solid& p, const Solid& q) {
  return std::ranges::all_of(std::initializer_list<mpq_class Point::*>{&Point::x, &Point::y, &Point::z}, [&](auto c) {
    const auto [p_low, p_high] = std::ranges::minmax(p, {}, c);
    const auto [q_low, q_high] = std::ranges::minmax(q, {}, c);
    return q_low.*c < p_high.*c && p_low.*c < q_high.*c;
  });
}

bool overlap(const Solid& p, const Solid& q, Monitor* monitor) {
  return boxes_overlap(p, q) && exact_depth(p, q, monitor).status() == Status::penetrating;
}

/// The least number by which all coordinates become integers.
mpz_class common_denominator(std::initializer_list<const Pieces*> bodies) {
  mpz_class result = 1;
  for (const Pieces* body : bodies)
    for (const Solid& piece : *body)
      for (const Point& p : piece)
        for (const mpq_class* c : {&p.x, &p.y, &p.z}) result = lcm(result, c->get_den());
  return result;
}

/// Six times the volume of the hull of integer points.
mpz_class volume(const Solid& points) {
  const polytope::Polytope hull = polytope::convex_hull(unions::integers(points));
  mpz_class result = 0;
  for (const polytope::Facet& facet : hull.facets)
    for (std::uint32_t i = facet.begin + 1; i + 1 < facet.end; ++i)
      result += det(hull.vertices[hull.corners[facet.begin]], hull.vertices[hull.corners[i]],
                    hull.vertices[hull.corners[i + 1]]);
  return result;
}

/// Whether the pieces, which have integer points, do not overlap and fill their hull.
bool fill_hull(const Pieces& body, Monitor* monitor) {
  mpz_class sum = 0;
  for (const Solid& piece : body) sum += volume(piece);
  if (sum != volume(unions::joined(body))) return false;
  for (std::size_t i = 0; i < body.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(body[i], body[j], monitor)) return false;
  return true;
}

bool is_before(const Point& p, const Point& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); }

/// Each piece once.
Pieces distinct(Pieces body) {
  for (Solid& piece : body) std::ranges::sort(piece, is_before);
  std::ranges::sort(
      body, [](const Solid& p, const Solid& q) { return std::ranges::lexicographical_compare(p, q, is_before); });
  body.erase(std::unique(body.begin(), body.end()), body.end());
  return body;
}

/// Whether any pieces overlap; if not, how near the nearest are.
std::optional<mpq_class> distance(const Pieces& a, const Pieces& b, Monitor* monitor) {
  std::optional<mpq_class> least;
  for (const Solid& p : a)
    for (const Solid& q : b) {
      const Depth depth = exact_depth(p, q, monitor);
      if (depth.status() == Status::penetrating) return std::nullopt;
      const mpq_class here = depth.distance() ? depth.distance()->squared : mpq_class(0);
      if (!least || here < *least) least = here;
    }
  return least;
}

void add(UnionsFound& answer, const Point& translation) { answer.translations.push_back(translation); }

UnionsFound of_whole(const Pieces& a, const Pieces& b, Monitor* monitor) {
  const Depth depth = exact_depth(unions::joined(a), unions::joined(b), monitor);
  UnionsFound answer{depth.status(), depth.squared(), {}};
  for (const Optimum& optimum : depth.optima()) add(answer, optimum.translation());
  return answer;
}

UnionsFound of_planes(unions::NaiveSearch& search) {
  const unions::NaiveUnion found = search.run();
  UnionsFound answer{Status::penetrating, found.squared, {}};
  for (const auto& [x, y, z] : found.optima) add(answer, {x, y, z});
  return answer;
}

/// B out of A, somewhere else: the translations are those of A, reversed.
UnionsFound mirrored(const Pieces& a, const Pieces& b, Monitor* monitor) {
  const Point by{5, -7, 11};
  const mpq_class factor(3);
  const auto there = [&](const Pieces& body) { return unions::scaled(unions::moved(body, by), factor); };
  const UnionDepth depth = union_depth(there(b), there(a), {monitor, false});
  UnionsFound answer{depth.status, mpq_class(depth.squared() / (factor * factor)), {}};
  for (const UnionOptimum& optimum : depth.optima) {
    const Point& t = optimum.translation;
    add(answer, {mpq_class(-t.x / factor), mpq_class(-t.y / factor), mpq_class(-t.z / factor)});
  }
  return answer;
}

/// Of unions that penetrate, with integer points.
UnionsFound penetrating(const Pieces& a, const Pieces& b, Monitor* monitor, Part& taken) {
  taken = Part::whole;
  if (fill_hull(a, monitor) && fill_hull(b, monitor)) return of_whole(a, b, monitor);
  unions::NaiveSearch search(a, b);
  taken = search.planes() <= most_planes ? Part::planes : Part::mirrored;
  return taken == Part::planes ? of_planes(search) : mirrored(a, b, monitor);
}

}  // namespace

UnionsFound unions_by_parts(const Case& pair, Monitor* monitor, Part* part) {
  Part unwanted{};
  Part& taken = part ? *part : unwanted;
  Pieces a = pieces_of(pair.a), b = pieces_of(pair.b);
  if (const std::optional<mpq_class> apart = distance(a, b, monitor)) {
    taken = Part::none;
    return {*apart == 0 ? Status::touching : Status::disjoint, *apart, {}};
  }
  const mpq_class unit(common_denominator({&a, &b}));
  UnionsFound answer = penetrating(distinct(unions::scaled(std::move(a), unit)),
                                   distinct(unions::scaled(std::move(b), unit)), monitor, taken);
  answer.squared /= unit * unit;
  for (Point& t : answer.translations) t = {mpq_class(t.x / unit), mpq_class(t.y / unit), mpq_class(t.z / unit)};
  std::ranges::sort(answer.translations, is_before);
  return answer;
}

harness::Solver second_solver() {
  harness::Solver solver = harness::solver_by(Method::exact);
  solver.of_unions = [](const Case& pair, Monitor* monitor) { return unions_by_parts(pair, monitor); };
  return solver;
}

}  // namespace fathom::nightly
