// SPDX-License-Identifier: GPL-3.0-or-later
// The naive check of a certificate: in rationals, by the definitions, slow. Convexity is global here (every vertex against every
// facet), where the checkers' is local (each edge).
#include <algorithm>
#include <set>

#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"

namespace fathom::certificate {
namespace {

class Check {
 public:
  explicit Check(const Certificate& certificate) : c_(certificate) {}

  kernels::Report run() {
    if (!report_.expect(!c_.a.empty() && !c_.b.empty(), "an empty body")) return report_;
    if (!report_.expect(!c_.directions.empty(), "no direction")) return report_;
    for (const Vector& n : c_.directions)
      if (report_.expect(!is_zero(n), "the zero direction")) direction(n);
    if (c_.claim == ClaimKind::depth) report_.expect(c_.low > 0 && c_.low == c_.high, "not one positive depth");
    if (c_.claim == ClaimKind::bounds) report_.expect(c_.low >= 0 && c_.high >= c_.low && c_.high > 0, "not a lower and an upper bound");
    if (c_.claim == ClaimKind::apart) report_.expect(c_.low > 0 && c_.low == c_.high, "not one positive distance");
    if (c_.claim == ClaimKind::depth || c_.claim == ClaimKind::bounds) inner_polytope();
    if (c_.claim == ClaimKind::depth) all_optima();
    else report_.expect(c_.directions.size() == 1, "more than one direction");
    if (c_.claim == ClaimKind::touching || c_.claim == ClaimKind::apart) nearest_points();
    return report_;
  }

 private:
  [[nodiscard]] mpq_class support(const Vector& n) const {
    mpq_class low = dot(n, c_.a.front()), high = dot(n, c_.b.front());
    for (const Point& p : c_.a) low = std::min(low, dot(n, p));
    for (const Point& p : c_.b) high = std::max(high, dot(n, p));
    return high - low;
  }

  void direction(const Vector& n) {
    const mpq_class h = support(n), square = dot(n, n);
    switch (c_.claim) {
      case ClaimKind::depth: report_.expect(h > 0 && h * h == c_.low * square, "a direction does not show the depth"); break;
      case ClaimKind::bounds: report_.expect(h > 0 && h * h <= c_.high * square, "the direction does not show the upper bound"); break;
      case ClaimKind::touching: report_.expect(h == 0, "the plane through O does not support P"); break;
      case ClaimKind::apart: report_.expect(h < 0 && h * h == c_.low * square, "the direction does not show the distance"); break;
    }
  }

  bool resolve() {
    for (const auto& [i, j] : c_.inner.vertices) {
      if (!report_.expect(i < c_.a.size() && j < c_.b.size(), "a vertex of Q has an index out of range")) return false;
      vertices_.push_back(c_.b[j] - c_.a[i]);
    }
    for (const std::vector<std::uint32_t>& facet : c_.inner.facets) {
      const bool in_range = std::all_of(facet.begin(), facet.end(), [&](std::uint32_t v) { return v < vertices_.size(); });
      if (!report_.expect(facet.size() >= 3 && in_range, "a facet of Q is no cycle of its vertices")) return false;
    }
    return report_.expect(c_.inner.facets.size() >= 4, "Q has fewer than four facets");
  }

  void inner_polytope() {
    if (!resolve()) return;
    for (const std::vector<std::uint32_t>& facet : c_.inner.facets) facet_of_q(facet);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const std::vector<std::uint32_t>& facet : c_.inner.facets)
      for (std::size_t k = 0; k < facet.size(); ++k)
        report_.expect(edges.insert({facet[k], facet[(k + 1) % facet.size()]}).second, "two facets of Q run along an edge in one sense");
    for (const auto& [u, v] : edges) report_.expect(edges.contains({v, u}), "an edge of Q has a facet on one side only");
  }

  void facet_of_q(const std::vector<std::uint32_t>& facet) {
    Point normal;
    for (std::size_t k = 0; k < facet.size(); ++k) {
      normal = normal + cross(vertices_[facet[k]], vertices_[facet[(k + 1) % facet.size()]]);
    }
    const mpq_class height = dot(normal, vertices_[facet.front()]), square = dot(normal, normal);
    report_.expect(height > 0 && height * height >= c_.low * square, "a facet of Q is too near");
    std::size_t on_plane = 0;
    for (const Point& v : vertices_) {
      const int order = cmp(dot(normal, v), height);
      report_.expect(order <= 0, "a vertex of Q lies above a facet");
      on_plane += order == 0 ? 1U : 0U;
    }
    report_.expect(on_plane == facet.size(), "the corners of a facet of Q are not the vertices on its plane");
    for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
      const Point side = cross(vertices_[facet[k]], vertices_[facet[k + 1]]);
      report_.expect(dot(side, vertices_[facet.front()]) > 0, "the corners of a facet of Q are not counter-clockwise");
    }
    if (height * height == c_.low * square) tight_.push_back(normal);
  }

  [[nodiscard]] static bool parallel(const Vector& n, const Point& m) {
    const Point p{n.x, n.y, n.z};
    return cross(p, m) == Point{} && dot(p, m) > 0;
  }

  void all_optima() {
    for (std::size_t i = 0; i < c_.directions.size(); ++i) {
      const Vector& n = c_.directions[i];
      report_.expect(primitive(n) == n, "a direction is not primitive");
      report_.expect(i == 0 || lexicographically_less(c_.directions[i - 1], n), "the directions are not in order");
      report_.expect(std::any_of(tight_.begin(), tight_.end(), [&](const Point& m) { return parallel(n, m); }),
                     "a direction without a facet");
    }
    if (!c_.complete) return;
    for (const Point& m : tight_)
      report_.expect(std::any_of(c_.directions.begin(), c_.directions.end(), [&](const Vector& n) { return parallel(n, m); }),
                     "an optimum is missing");
  }

  Point combined(const std::vector<Point>& points, const std::vector<Weight>& weights) {
    Point sum;
    mpq_class total;
    for (const Weight& w : weights) {
      if (!report_.expect(w.index < points.size() && w.weight > 0, "a weight that is none")) continue;
      total += w.weight;
      sum = sum + w.weight * points[w.index];
    }
    report_.expect(total == 1, "weights do not sum to 1");
    return sum;
  }

  // Touching: one common point.
  void nearest_points() {
    const Point z = combined(c_.b, c_.weights_b) - combined(c_.a, c_.weights_a);
    report_.expect(dot(z, z) == c_.low, "the weighted points are not as near as is said");
  }

  const Certificate& c_;
  kernels::Report report_;
  std::vector<Point> vertices_, tight_;
};

}  // namespace

kernels::Report validate(const Certificate& certificate) { return Check(certificate).run(); }

}  // namespace fathom::certificate
