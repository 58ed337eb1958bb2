// SPDX-License-Identifier: GPL-3.0-or-later
// What every result must satisfy, recomputed from the input points by the definitions of docs/algorithm.md alone.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "kernels/report.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::testing {

inline mpq_class along(const Vector& u, const Point& p) { return u.x * p.x + u.y * p.y + u.z * p.z; }

/// The extreme points of a body in direction u, by definition: as indices, extreme points of the body only, lowest index of equal ones.
inline std::vector<std::uint32_t> face(std::span<const Point> points, const std::vector<std::uint32_t>& extreme, const Vector& u) {
  mpq_class best = along(u, points[extreme.front()]);
  for (const std::uint32_t i : extreme) best = std::max(best, along(u, points[i]));
  std::vector<std::uint32_t> result;
  for (const std::uint32_t i : extreme) {
    if (along(u, points[i]) == best) result.push_back(i);
  }
  return result;
}

/// h(u) = max_b <u,b> - min_a <u,a>.
inline mpq_class support(std::span<const Point> a, std::span<const Point> b, const Vector& u) {
  mpq_class low = along(u, a.front()), high = along(u, b.front());
  for (const Point& p : a) low = std::min(low, along(u, p));
  for (const Point& p : b) high = std::max(high, along(u, p));
  return high - low;
}

/// Whether p is in the hull of the chosen points.
inline bool in_hull(const Point& p, std::span<const Point> points, const std::vector<std::uint32_t>& chosen) {
  std::vector<Point> corners;
  for (const std::uint32_t i : chosen) corners.push_back(points[i]);
  const Lattice lattice = common_lattice({&p, 1}, corners);
  const long exponent = std::max(binary_exponent(lattice.a), binary_exponent(lattice.b));
  return position_of_origin(PointCloud(lattice.a, exponent), PointCloud(lattice.b, exponent)).position != Position::outside;
}

inline ContactKind kind_of(std::size_t a, std::size_t b) {
  if (a >= 3) return b == 1 ? ContactKind::facet_vertex : b == 2 ? ContactKind::facet_edge : ContactKind::facet_facet;
  if (b >= 3) return a == 1 ? ContactKind::vertex_facet : ContactKind::edge_facet;
  return ContactKind::edge_edge;
}

/// The laws of a result: every field against the definitions. Not that the minimum is a minimum; oracles tell that.
inline Report check(const Depth& depth, std::span<const Point> a, std::span<const Point> b) {
  Report report;
  const Lattice lattice = common_lattice(a, b);
  const Polytope hull_a = convex_hull(lattice.a), hull_b = convex_hull(lattice.b);
  report.expect(depth.flat_a == (hull_a.rank < 3) && depth.flat_b == (hull_b.rank < 3), "flat flags");
  if (depth.status() != Status::penetrating) {
    report.expect(depth.squared() == 0 && depth.optima().empty() && !depth.contact() && depth.translation() == Point{}, "nothing but zero");
    if (report.expect(depth.direction().has_value(), "no separating direction")) {
      const int sign = sgn(support(a, b, depth.direction()));
      report.expect(!is_zero(depth.direction()) && (depth.status() == Status::touching ? sign == 0 : sign < 0),
                    "h of the separating direction");
    }
    report.expect(depth.witness().has_value() == (depth.status() == Status::touching), "a common point exactly when touching");
    if (depth.witness()) {
      report.expect(depth.witness()->a == depth.witness()->b, "the common point is one point");
      report.expect(in_hull(depth.witness()->a, a, hull_a.input_ids) && in_hull(depth.witness()->b, b, hull_b.input_ids),
                    "common point in both");
    }
    return report;
  }
  report.expect(!depth.optima().empty() && depth.squared() > 0, "a penetrating pair has an optimum");
  report.expect(std::ranges::is_sorted(depth.optima(), lexicographically_less, &Optimum::direction), "optima are sorted");
  for (const Optimum& o : depth.optima()) {
    const Vector& n = o.direction;
    const mpq_class h = support(a, b, n), square(dot(n, n));
    report.expect(primitive(n) == n, "direction is not primitive");
    report.expect(h > 0 && h * h == depth.squared() * square, "h(n)^2 = q <n,n>");
    report.expect(o.translation == Point{h / square * n.x, h / square * n.y, h / square * n.z}, "translation");
    report.expect(o.contact.a == face(a, hull_a.input_ids, -n) && o.contact.b == face(b, hull_b.input_ids, n), "contact features");
    report.expect(o.contact.kind == kind_of(o.contact.a.size(), o.contact.b.size()), "contact kind");
  }
  const Optimum& first = depth.optima().front();
  report.expect(depth.direction() == first.direction && depth.translation() == first.translation && depth.contact() == first.contact,
                "first optimum");
  if (report.expect(depth.witness().has_value(), "no witness")) {
    const Point& p = depth.witness()->a;
    const Point& q = depth.witness()->b;
    const Point difference{q.x - p.x, q.y - p.y, q.z - p.z};
    report.expect(difference == depth.translation(), "witness points do not differ by the translation");
    report.expect(in_hull(p, a, first.contact.a) && in_hull(q, b, first.contact.b), "witness point off its face");
  }
  return report;
}

}  // namespace fathom::testing
