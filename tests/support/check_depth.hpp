// SPDX-License-Identifier: GPL-3.0-or-later
// What every result must satisfy, recomputed from the input points by the definitions of
// docs/algorithm.md. Hulls are not asked; whether a point is in a hull is believed only with a
// proof.
#pragma once

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/messages.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::testing {

using Ids = std::vector<std::uint32_t>;
using Rational = Vec3<mpq_class>;

/// h(u) = max_b <u,b> - min_a <u,a>.
inline mpq_class support(std::span<const Point> a, std::span<const Point> b, const Vector& u) {
  mpq_class low = dot(u, a.front()), high = dot(u, b.front());
  for (const Point& p : a) low = std::min(low, dot(u, p));
  for (const Point& p : b) high = std::max(high, dot(u, p));
  return high - low;
}

inline Ids all_of(std::span<const Point> points) {
  Ids all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

/// Whether p is in the hull of the chosen points. The proof of the answer is checked.
inline bool in_hull(const Point& p, std::span<const Point> points, const Ids& chosen) {
  std::vector<Point> corners;
  for (const std::uint32_t i : chosen) corners.push_back(points[i]);
  const polytope::PlacedPair placed = polytope::place({&p, 1}, corners);
  const polytope::PositionOfOrigin answer = polytope::position_of_origin(placed.a, placed.b);
  kernels::insist(polytope::validate(answer, placed.a.points(), placed.b.points()));
  return answer.position != polytope::Position::outside;
}

/// The dimension of the hull of the chosen points.
inline int rank_of(std::span<const Point> points, const Ids& chosen) {
  int rank = 0;
  Rational first, normal;
  for (const std::uint32_t i : chosen) {
    const Point p = points[i] - points[chosen.front()];
    const Rational d{p.x, p.y, p.z}, zero;
    if (rank == 0 && d != zero) {
      first = d;
      rank = 1;
    } else if (rank == 1 && cross(first, d) != zero) {
      normal = cross(first, d);
      rank = 2;
    } else if (rank == 2 && dot(normal, d) != 0) {
      return 3;
    }
  }
  return rank;
}

/// The face of a body in direction u: the extreme points of the body that maximise <u,p>, of equal
/// ones the lowest index, ascending.
inline Ids face(std::span<const Point> points, const Vector& u) {
  mpq_class best = dot(u, points.front());
  for (const Point& p : points) best = std::max(best, dot(u, p));
  Ids greatest;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto is_point_i = [&](std::uint32_t j) { return points[j] == points[i]; };
    if (dot(u, points[i]) == best && std::ranges::none_of(greatest, is_point_i)) greatest.push_back(i);
  }
  Ids extreme;
  for (const std::uint32_t i : greatest) {
    Ids others = greatest;
    std::erase(others, i);
    if (others.empty() || !in_hull(points[i], points, others)) extreme.push_back(i);
  }
  return extreme;
}

/// By the dimensions of the faces.
inline ContactKind kind_of(const Contact& contact, std::span<const Point> a, std::span<const Point> b) {
  switch (10 * rank_of(a, contact.a) + rank_of(b, contact.b)) {
    case 20: return ContactKind::facet_vertex;
    case 2: return ContactKind::vertex_facet;
    case 21: return ContactKind::facet_edge;
    case 12: return ContactKind::edge_facet;
    case 22: return ContactKind::facet_facet;
    case 11: return ContactKind::edge_edge;
    case 0: return ContactKind::vertex_vertex;
    case 1: return ContactKind::vertex_edge;
    case 10: return ContactKind::edge_vertex;
    default: throw std::logic_error("a face of another dimension than 0, 1 and 2");
  }
}

inline void check(const Touch& touch, std::span<const Point> a, std::span<const Point> b, kernels::Report& report) {
  report.expect(
      !is_zero(touch.direction) && primitive(touch.direction) == touch.direction && support(a, b, touch.direction) == 0,
      "touching: h of the direction is 0");
  report.expect(in_hull(touch.point, a, all_of(a)) && in_hull(touch.point, b, all_of(b)), "common point in both");
}

/// The distance is right: no direction separates more widely than |b - a| for some a and b.
inline void check(const Distance& distance, std::span<const Point> a, std::span<const Point> b,
                  kernels::Report& report) {
  const Vector& n = distance.direction;
  const mpq_class h = support(a, b, n), square(dot(n, n));
  report.expect(!is_zero(n) && primitive(n) == n && h < 0, "disjoint: h of the direction is negative");
  report.expect(h * h == distance.squared * square, "h(n)^2 = distance^2 <n,n>");
  report.expect(distance.translation == h / square * n, "translation of the distance");
  const auto& [p, q] = distance.witness;
  report.expect(q - p == distance.translation, "nearest points differ by the translation");
  report.expect(in_hull(p, a, all_of(a)) && in_hull(q, b, all_of(b)), "nearest points in their bodies");
  report.expect(distance.contact.a == face(a, -n) && distance.contact.b == face(b, n),
                "faces in the direction of the distance");
  report.expect(distance.contact.kind == kind_of(distance.contact, a, b), "what these faces are");
  report.expect(in_hull(p, a, distance.contact.a) && in_hull(q, b, distance.contact.b),
                "nearest points in these faces");
}

/// Not that the minimum is a minimum; oracles tell that.
inline void check(const Penetration& penetration, std::span<const Point> a, std::span<const Point> b,
                  kernels::Report& report) {
  const std::vector<Optimum>& optima = penetration.optima;
  if (!report.expect(!optima.empty() && penetration.squared() > 0, "a penetrating pair has an optimum")) return;
  report.expect(std::ranges::is_sorted(optima, lexicographically_less, &Optimum::direction), "optima are sorted");
  for (const Optimum& o : optima) {
    const Vector& n = o.direction;
    const mpq_class h = support(a, b, n), square(dot(n, n));
    report.expect(primitive(n) == n, "direction is not primitive");
    report.expect(h > 0 && h * h == penetration.squared() * square, "h(n)^2 = q <n,n>");
    report.expect(o.translation() == h / square * n, "translation");
    report.expect(o.contact.a == face(a, -n) && o.contact.b == face(b, n), "contact features");
    report.expect(o.contact.kind == kind_of(o.contact, a, b), "contact kind");
  }
  const Optimum& first = optima.front();
  const auto& [p, q] = penetration.witness();
  report.expect(q - p == first.translation(), "witness points do not differ by the translation");
  report.expect(in_hull(p, a, first.contact.a) && in_hull(q, b, first.contact.b), "witness point off its face");
}

/// The laws of a result: every field against the definitions.
inline kernels::Report check(const Depth& depth, std::span<const Point> a, std::span<const Point> b) {
  kernels::Report report;
  report.expect(depth.flat_a == (rank_of(a, all_of(a)) < 3) && depth.flat_b == (rank_of(b, all_of(b)) < 3),
                "flat flags");
  std::visit([&](const auto& outcome) { check(outcome, a, b, report); }, depth.outcome);
  const std::optional<Witness> witness = depth.witness();
  const Witness points = depth.contact_points();
  report.expect(points.b - points.a == depth.contact_translation() &&
                    (depth.distance() ? points == depth.distance()->witness : points == witness),
                "points by whose difference the bodies touch");
  if (const Penetration* penetration = depth.penetration()) {
    const Optimum& first = penetration->optima.front();
    report.expect(depth.status() == Status::penetrating && depth.squared() == penetration->squared() &&
                      depth.optima() == penetration->optima && depth.direction() == first.direction &&
                      depth.translation() == first.translation() && *depth.contact() == first.contact &&
                      witness == penetration->witness() && signed_square(depth) == depth.squared(),
                  "accessors of a penetrating pair");
    return report;
  }
  report.expect(depth.squared() == 0 && depth.optima().empty() && depth.translation() == Point{}, "nothing but zero");
  if (const Touch* touch = depth.touch()) {
    report.expect(depth.status() == Status::touching && !depth.contact() && depth.direction() == touch->direction &&
                      witness && witness->a == touch->point && witness->b == touch->point && signed_square(depth) == 0,
                  "accessors of a touching pair");
  } else {
    report.expect(depth.status() == Status::disjoint && depth.direction() == depth.distance()->direction && !witness &&
                      depth.contact() == &depth.distance()->contact &&
                      signed_square(depth) == -depth.distance()->squared,
                  "accessors of a disjoint pair");
  }
  return report;
}

}  // namespace fathom::testing
