// SPDX-License-Identifier: GPL-3.0-or-later
// The two bodies, and their exact quantities that the judge needs.
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

/// Returns the sizes of two bodies, which are not empty; with dimension 2 those along x and y.
Sizes sizes_of(std::span<const Point> a, std::span<const Point> b, unsigned dimension = 3);
/// Returns the sizes of unions.
Sizes sizes_of(const Pieces& a, const Pieces& b, unsigned dimension = 3);
/// Returns the sizes of shapes, rounded up, with roots of `bits` bits. A half-space counts as the
/// point O.
Sizes sizes_of(const Shape& a, const Shape& b, unsigned bits, unsigned dimension = 3);

/// Exact measures of polytopes. Refers to the truth, which must outlive it. Below, h(u) = max_b
/// <u,b> - min_a <u,a>.
class Scene {
 public:
  explicit Scene(const Truth& truth);
  ~Scene();

  /// Returns h(u) / |u|, as a signed square. The direction must not be zero.
  [[nodiscard]] mpq_class separating_distance_squared(const Vector& u) const;
  /// Returns the squared length of the shortest translation along u after which the interiors are
  /// disjoint; 0 if they are disjoint already.
  [[nodiscard]] mpq_class exit_distance_squared(const Vector& u);

 private:
  const Truth& truth_;
  polytope::PlacedPair placed_;
  std::unique_ptr<const BodyPair> pair_;  ///< made on demand
};

/// Returns the greatest f with f u in P = B (+) (-A), in units of the lattice: exact. It starts
/// from a polytope Q inside P, from a certificate of the depth, so that it needs no hulls. Its twin
/// is directional_depth. Returns nullopt after `patience` support queries; only rays through edges
/// and corners may need many. u must not be zero. [proofs/judge.md]
std::optional<mpq_class> way_out(const polytope::PlacedPair& placed, const InnerPolytope& inside, const Vector& u,
                                 unsigned patience = 200);

/// The position of a point outside a body.
struct Outside {
  mpq_class squared;  ///< of its distance
  Vector away;        ///< primitive, from the nearest point of the body to it
};
/// Returns nullopt if the body's hull contains the point. The body must not be empty.
std::optional<Outside> outside_of(const Point& point, std::span<const Point> body);
/// Returns the squared distance of a point from the hull of the others; 0 inside. The body must not
/// be empty.
mpq_class squared_distance(const Point& point, std::span<const Point> body);
/// Returns the squared distance of a point from the union of pieces; 0 inside.
mpq_class squared_distance(const Point& point, const Pieces& body);

}  // namespace fathom::judging
