// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/approximate/ray_levels.hpp"

#include <algorithm>

#include "reference/polytope/hierarchy.hpp"

namespace fathom::approximate {
namespace {

Vector times_4(const Vector& v) { return {4 * v.x, 4 * v.y, 4 * v.z}; }

/// 4 (b - a + t) for all b, a and t of three short lists, and the anchors.
struct SmallSum {
  std::vector<Vector> b, a, t;
  const std::array<Vector, 4>* anchors;
};

const Vector& highest(const std::vector<Vector>& points, const Vector& u, int sense) {
  return *std::ranges::max_element(points, {}, [&](const Vector& p) { return mpz_class(sense * dot(u, p)); });
}

Vector highest(const SmallSum& sum, const Vector& u) {
  const Vector p = times_4(highest(sum.b, u, 1) - highest(sum.a, u, -1) + highest(sum.t, u, 1));
  const Vector& anchor = *std::ranges::max_element(*sum.anchors, {}, [&](const Vector& q) { return dot(u, q); });
  return dot(u, anchor - p) > 0 ? anchor : p;
}

Portal pierce(const SmallSum& sum, const PushedRay& ray, polytope::Steps& steps) {
  const auto support = [&](const Vector& u) {
    steps += sum.b.size() + sum.a.size() + sum.t.size() + sum.anchors->size();
    return highest(sum, u);
  };
  return *refine(portal_of_tetrahedron(*sum.anchors, ray), ray, support);
}

/// All sums of t or -t, one for each t of the thickness: the corners of its zonotope.
std::vector<Vector> corners_of(const std::vector<Vector>& thickness) {
  std::vector<Vector> corners{Vector{0, 0, 0}};
  for (const Vector& t : thickness) {
    for (std::size_t i = corners.size(); i-- > 0;) {
      corners.push_back(corners[i] + t);
      corners[i] = corners[i] - t;
    }
  }
  return corners;
}

std::vector<Vector> points_of(const polytope::Hierarchy& h, const std::vector<polytope::VertexId>& vertices) {
  std::vector<Vector> points;
  for (const polytope::VertexId v : vertices) points.push_back(h.polytope().vertices[v]);
  return points;
}

/// The highest vertex of a descent, new at its level, and its neighbours there.
std::vector<Vector> star(const polytope::Hierarchy& h, const polytope::HierarchyDescent& descent) {
  std::vector<polytope::VertexId> vertices = descent.neighbours();
  vertices.push_back(descent.highest());
  return points_of(h, vertices);
}

class Levels {
 public:
  Levels(const std::array<Vector, 4>& anchors, const PushedRay& ray, SupportOfSum& support)
      : ray_(ray), support_(support), down_a_(*support.a), down_b_(*support.b) {
    sum_.t = corners_of(*support.thickness);
    sum_.anchors = &anchors;
  }

  Portal run() {
    sum_.b = points_of(*support_.b, down_b_.coarsest());
    descend_a();
    down_b_.start(normal_);
    while (!down_b_.at_finest()) {
      if (!down_b_.step_down() || !beyond(b(), a())) continue;
      sum_.b = star(*support_.b, down_b_);
      descend_a();
      down_b_.turn_to(normal_);
    }
    support_.steps += steps_ + down_a_.steps() + down_b_.steps();
    return portal_;
  }

 private:
  [[nodiscard]] const Vector& a() const { return support_.a->polytope().vertices[down_a_.highest()]; }
  [[nodiscard]] const Vector& b() const { return support_.b->polytope().vertices[down_b_.highest()]; }
  [[nodiscard]] bool beyond(const Vector& b, const Vector& a) {
    ++steps_;
    return dot(normal_, times_4(b - a + highest(sum_.t, normal_, 1)) - portal_[0]) > 0;
  }
  void pierce_sum() {
    portal_ = pierce(sum_, ray_, steps_);
    normal_ = normal_of(portal_);
  }

  /// The portal of B as it stands in the sum, and of all of A.
  void descend_a() {
    sum_.a = points_of(*support_.a, down_a_.coarsest());
    pierce_sum();
    down_a_.start(-normal_);
    while (!down_a_.at_finest()) {
      if (!down_a_.step_down() || !beyond(highest(sum_.b, normal_, 1), a())) continue;
      sum_.a = star(*support_.a, down_a_);
      pierce_sum();
      down_a_.turn_to(-normal_);
    }
  }

  const PushedRay& ray_;
  SupportOfSum& support_;
  polytope::HierarchyDescent down_a_, down_b_;
  SmallSum sum_;
  Portal portal_;
  Vector normal_;
  polytope::Steps steps_ = 0;
};

}  // namespace

Portal refine_by_levels(const std::array<Vector, 4>& anchors, const PushedRay& ray, SupportOfSum& support) {
  return Levels(anchors, ray, support).run();
}

}  // namespace fathom::approximate
