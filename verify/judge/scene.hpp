// SPDX-License-Identifier: GPL-3.0-or-later
// The two bodies, and the exact quantities that a judge needs of them.
//                                                               [AGHRS, section 3; proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include <memory>
#include <optional>
#include <span>

#include "fathom/depth.hpp"
#include "fathom/judge.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom {

class BodyPair;

}  // namespace fathom

namespace fathom::judging {

/// Lengths of two bodies along the axes.
struct Sizes {
  mpq_class extent;    ///< the longest side of the bodies' boxes, the larger of the two
  mpq_class farthest;  ///< the largest absolute coordinate of a point
  mpq_class reach;     ///< the largest absolute coordinate of a difference b - a
};

/// Returns the sizes of two bodies, which are not empty.
Sizes sizes_of(std::span<const Point> a, std::span<const Point> b);
/// Returns the sizes of unions.
Sizes sizes_of(const Pieces& a, const Pieces& b);
/// Returns the sizes of shapes, rounded up, with roots of `bits` bits. A half-space counts as the
/// point O.
Sizes sizes_of(const Shape& a, const Shape& b, unsigned bits);

/// Refers to the truth. Below, h(u) = max_b <u,b> - min_a <u,a>.
class Scene {
 public:
  explicit Scene(const Truth& truth);
  ~Scene();

  /// h(u) / |u|, as a signed square. The direction is not zero.
  [[nodiscard]] mpq_class separating_distance_squared(const Vector& u) const;
  /// The squared length of the shortest way along u after which the interiors are disjoint; 0 if
  /// they are disjoint already.
  [[nodiscard]] mpq_class exit_distance_squared(const Vector& u);

 private:
  const Truth& truth_;
  polytope::PlacedPair placed_;
  std::unique_ptr<const BodyPair> pair_;  ///< made when it is first needed
};

/// Where the ray from O along u leaves P = B (+) (-A), by a polytope Q inside P from a certificate
/// of the depth: no hulls are needed. Its twin is directional_depth. Returns the greatest f with f
/// u in P, in units of the lattice: exact. Returns nullopt after `patience` support queries; only
/// rays through edges and corners may need many. u is not zero. [proofs/judge.md]
std::optional<mpq_class> way_out(const polytope::PlacedPair& placed, const InnerPolytope& inside, const Vector& u,
                                 unsigned patience = 200);

/// How a point lies outside of a body.
struct Outside {
  mpq_class squared;  ///< of its distance
  Vector away;        ///< primitive, from the nearest point of the body to it
};
/// nullopt if the hull of the others holds the point. The body is not empty.
std::optional<Outside> outside_of(const Point& point, std::span<const Point> body);
/// The squared distance of a point from the hull of the others; 0 inside. The body is not empty.
mpq_class squared_distance(const Point& point, std::span<const Point> body);
/// Returns the squared distance of a point from the union of pieces; 0 inside.
mpq_class squared_distance(const Point& point, const Pieces& body);

}  // namespace fathom::judging
