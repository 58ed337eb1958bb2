// SPDX-License-Identifier: GPL-3.0-or-later
// A facet of P as the sum of two convex polygons in parallel planes: their edges, merged by angle. Part of sum_facets.hpp.
#include <algorithm>

#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

using polytope::VertexId;

/// Angles around n, counter-clockwise from a direction r in its plane.
struct Turn {
  Vector n, r, w;  // w = n x r is a right angle from r

  /// Whether the angle of d is at least pi.
  [[nodiscard]] bool is_late(const Vector& d) const {
    const int side = sgn(dot(w, d));
    return side < 0 || (side == 0 && sgn(dot(r, d)) < 0);
  }
  /// Negative: d has the smaller angle. Zero: the same.
  [[nodiscard]] int compare(const Vector& d, const Vector& e) const {
    const bool late = is_late(d);
    if (late != is_late(e)) return late ? 1 : -1;
    return -sgn(det(n, d, e));
  }
};

/// One of the two polygons: those of B as they are, those of A reflected. Its edges are taken by angle.
class Side {
 public:
  Side(const polytope::Polytope& body, bool reflected, std::vector<VertexId> cycle)
      : body_(&body), reflected_(reflected), cycle_(std::move(cycle)) {
    if (reflected_) std::ranges::reverse(cycle_);  // a facet of A faces -n
  }

  [[nodiscard]] Vector point(std::size_t i) const {
    const Vector& p = body_->vertices[cycle_[i % cycle_.size()]];
    return reflected_ ? -p : p;
  }
  [[nodiscard]] bool has_edges() const { return cycle_.size() > 1; }
  [[nodiscard]] Vector edge(std::size_t i) const { return point(i + 1) - point(i); }
  /// Starts at the corner behind which the angles of edges begin at 0.
  void start(const Turn& turn) {
    const auto lower = [&](std::size_t i, std::size_t j) {
      const Vector d = point(i) - point(j);
      const int side = sgn(dot(turn.w, d));
      return side < 0 || (side == 0 && sgn(dot(turn.r, d)) < 0);
    };
    std::size_t first = 0;
    for (std::size_t i = 1; i < cycle_.size(); ++i)
      if (lower(i, first)) first = i;
    std::rotate(cycle_.begin(), cycle_.begin() + static_cast<std::ptrdiff_t>(first), cycle_.end());
  }
  [[nodiscard]] bool done() const { return taken_ == (has_edges() ? cycle_.size() : 0); }
  [[nodiscard]] Vector next_edge() const { return edge(taken_); }
  void take() { ++taken_; }
  [[nodiscard]] VertexId corner() const { return cycle_[taken_ % cycle_.size()]; }

 private:
  const polytope::Polytope* body_;
  bool reflected_;
  std::vector<VertexId> cycle_;
  std::size_t taken_ = 0;
};

}  // namespace

std::vector<SumCorner> sum_cycle(const depth::Hulls& hulls, const Vector& normal, std::vector<VertexId> of_a, std::vector<VertexId> of_b) {
  Side a(hulls.a, true, std::move(of_a)), b(hulls.b, false, std::move(of_b));
  const Vector r = a.has_edges() ? a.edge(0) : b.edge(0);
  const Turn turn{normal, r, cross(normal, r)};
  a.start(turn);
  b.start(turn);
  std::vector<SumCorner> corners;
  while (!a.done() || !b.done()) {
    corners.push_back({a.corner(), b.corner()});
    const int order = a.done() ? 1 : b.done() ? -1 : turn.compare(a.next_edge(), b.next_edge());
    if (order <= 0) a.take();
    if (order >= 0) b.take();
  }
  return corners;
}

}  // namespace fathom::stages
