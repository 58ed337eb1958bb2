// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes in random poses, of all kinds that engines know, and of some that they do not.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "fathom/shape.hpp"
#include "verify/families/random.hpp"

namespace fathom::testing {

/// Coordinates of shapes are multiples of 2^-bits before they are posed.
struct ShapeMaker {
  families::Random random;
  unsigned bits;

  mpq_class length(std::int64_t low = 1, std::int64_t high = 4) {
    return families::random_dyadic(random, low, high, bits) / 2;
  }
  Point point(std::int64_t reach) {
    const mpq_class x = families::random_dyadic(random, -reach, reach, bits),
                    y = families::random_dyadic(random, -reach, reach, bits);
    return {x, y, families::random_dyadic(random, -reach, reach, bits)};
  }
  Quaternion rotation() {
    const Point v = point(1);
    const Quaternion q{families::random_dyadic(random, -1, 1, bits), v.x, v.y, v.z};
    return q == Quaternion{} ? Quaternion{1, 0, 0, 0} : q;
  }
  /// The center is at most `reach` from O along each axis.
  Shape posed(const Shape& shape, std::int64_t reach) {
    const Quaternion q = rotation();
    return moved(shape, rigid_pose(q, point(reach)));
  }

  static constexpr std::array<std::string_view, 11> kinds{
      "ellipsoid",        "cylinder",        "cone",          "frustum", "box", "disc", "ball", "tapered_capsule",
      "rounded_cylinder", "ellipsoid + box", "flat ellipsoid"};

  Shape shape(std::string_view kind) {
    const mpq_class r = length(), s = length(), t = length();
    if (kind == "ellipsoid") return ellipsoid({r, s, t});
    if (kind == "cylinder") return cylinder(r, s);
    if (kind == "cone") return cone(r, s, Axis::x);
    if (kind == "frustum") return frustum(r, s, t, Axis::y);
    if (kind == "box") return box({r, s, t});
    if (kind == "disc") return one_atom({{0, 0, 0}, {{r, 0, 0}, {0, s, 0}}});
    if (kind == "ball") return one_atom({{0, 0, 0}, {{r, 0, 0}, {0, r, 0}, {0, 0, r}}});
    if (kind == "tapered_capsule") return tapered_capsule(r, s, t);
    if (kind == "rounded_cylinder") return with_margin(cylinder(r, s), t / 4);
    if (kind == "ellipsoid + box") return minkowski_sum(ellipsoid({r, s, t}), box({s / 2, t / 2, r / 2}));
    return one_atom({{0, 0, 0}, {{r, 0, s}, {0, s, t}, {r, s, s + t}}});  // its axes lie in a plane
  }
  Shape any_shape() { return shape(kinds[static_cast<std::size_t>(random.between(0, kinds.size() - 1))]); }

  static Shape one_atom(Atom atom) {
    Shape result;
    std::get<std::vector<Term>>(result.core).push_back({{std::move(atom)}});
    return result;
  }
};

}  // namespace fathom::testing
