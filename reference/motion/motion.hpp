// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies in their frames, and their rigid motions.
// Output  what a separating direction comes to over an interval of time: polynomials in integers,
//         whose coefficients are positive only if it separates the bodies all along; and the bodies
//         at one time, on one lattice.                                         [proofs/impact.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fathom/impact.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::motion {

/// A polynomial over an interval: the sum of c_i (1-x)^(n-i) x^i, where x goes from 0 at its
/// beginning to 1 at its end. c_i is its Bernstein coefficient times a positive number: if all are
/// positive, so is it.
template <class T>
using Over = std::vector<T>;

/// A square matrix by its rows.
using Matrix = std::array<Vector, 3>;

/// One body's motion over an interval: its point x is at place + matrix x / weight, where the
/// matrix is the rotation times the weight.
struct MotionOver {
  Over<mpz_class> weight;  ///< |q|^2
  Over<Matrix> matrix;
  Over<Vector> place;  ///< times a number that both bodies share
};

/// How far apart the points of two bodies are in a direction: a positive multiple of <n, place of a
/// - place of b> is constant + <of_a, a> - <of_b, b>, each over the interval, of one degree.
struct GapOver {
  Over<mpz_class> constant;
  Over<Vector> of_a, of_b;
};

/// Of a gap over an interval whether it is positive for all points.
struct Holding {
  bool holds = false;
  Over<mpz_class> broken;  ///< if not: the gap of two points, of which a coefficient is not positive
};

/// Two bodies that move.
class MovingPair {
 public:
  /// Throws std::invalid_argument as first_contact does.
  MovingPair(std::span<const Point> a, const RigidMotion& of_a, std::span<const Point> b, const RigidMotion& of_b);

  /// Whether the direction separates the bodies strictly at every t in [s, e].
  [[nodiscard]] Holding holding(const MovingPlane& plane, const mpq_class& s, const mpq_class& e) const;
  /// The bodies at t, on a lattice whose origin is that of the world.
  [[nodiscard]] polytope::PlacedPair at(const mpq_class& t) const;
  /// Directions that may separate the bodies near t, where they are apart and nearest along n: a
  /// primitive vector of the world that points from B to A.
  [[nodiscard]] std::vector<MovingPlane> planes(const mpq_class& t, const polytope::PlacedPair& placed,
                                                const Vector& n) const;
  /// The direction at t, primitive.
  [[nodiscard]] Vector direction(const MovingPlane& plane, const mpq_class& t) const;
  /// The greatest absolute value of a coordinate of a point or of a place.
  [[nodiscard]] const mpq_class& extent() const { return extent_; }

 private:
  struct Mover {
    std::array<std::array<mpz_class, 4>, 2> q;  ///< at 0 and at 1, both times one number
    std::array<Vector, 2> p;                    ///< in units of the lattice
    bool turns;                                 ///< unless q at 1 is a positive multiple of q at 0
    kernels::PointCloud points;                 ///< in its frame
  };
  struct Interval;

  static MotionOver over(const Mover& mover, const Interval& interval);
  [[nodiscard]] GapOver gap(const MovingPlane& plane, const Interval& interval) const;
  [[nodiscard]] std::optional<MovingPlane> rounded(MovingPlane::Kind kind, const Vector& n, const mpq_class& t) const;

  mpz_class denominator_ = 1;  ///< of the lattice: lengths are multiples of 1 / denominator
  mpq_class extent_;
  Mover a_, b_;
};

}  // namespace fathom::motion
