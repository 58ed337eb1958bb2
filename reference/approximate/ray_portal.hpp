// SPDX-License-Identifier: GPL-3.0-or-later
// A ray leaves a convex polytope that is known by its support function alone: a triangle of its points that the ray pierces (a portal)
// is moved outward until its plane supports the polytope. For RayShooter.                                        [proofs/ray.md]
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "kernels/vector.hpp"
#include "reference/polytope/hierarchy.hpp"

namespace fathom::approximate {

/// A ray from start + e pushes[0] + e^2 pushes[1] + ... with an infinitesimal e > 0. Direction and pushes span space, so that in
/// projection along the direction the start lies on no line through two points that differ there.
struct PushedRay {
  Vector direction, start;
  std::vector<Vector> pushes;

  /// Seen with the direction pointing at the viewer: 1 if the start lies to the left of the way from p to q, -1 if to the right; 0 only
  /// if that way is parallel to the direction.
  [[nodiscard]] int side(const Vector& p, const Vector& q) const;
};

/// Corners of a triangle that the ray pierces in its interior, counter-clockwise seen with the ray's direction pointing at the viewer.
using Portal = std::array<Vector, 3>;

inline Vector normal_of(const Portal& p) { return cross(p[1] - p[0], p[2] - p[0]); }

/// Support queries of 4 P, where P = B (+) (-A) plus the segments from -t to t for each t of `thickness`.
struct SupportOfSum {
  const polytope::Hierarchy* a;
  const polytope::Hierarchy* b;
  const std::vector<Vector>* thickness;
  std::uint64_t queries = 0;
  polytope::Steps steps = 0;

  /// A point of P, not scaled and not thickened, that is extreme in direction u.
  Vector of_sum(const Vector& u);
  /// A point of 4 P, extreme in direction u.
  Vector operator()(const Vector& u);
};

/// The side of a tetrahedron through which a ray leaves that starts strictly inside.
Portal portal_of_tetrahedron(const std::array<Vector, 4>& corners, const PushedRay& ray);

/// Moves the portal outward until its plane supports a polytope, given by extreme points; or, when `within` is given, only until that
/// point lies strictly on the inner side. Returns nullopt after more than `patience` queries. The portal's corners must be points of the
/// polytope, and its plane must pass through the interior or support it.
std::optional<Portal> refine(Portal portal, const PushedRay& ray, const std::function<Vector(const Vector&)>& extreme,
                             const Vector* within = nullptr, std::uint64_t patience = std::numeric_limits<std::uint64_t>::max());

}  // namespace fathom::approximate
