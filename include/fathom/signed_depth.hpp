// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies that need not be polytopes: shapes.
// Output  their signed depth: > 0 if they penetrate, 0 if they touch, < 0 if they are disjoint.
//         Exact where both cores are polytopes, or one is a half-space and the other a polytope;
//         proved bounds else.                                                    [proofs/shapes.md]
//
// A and B are the cores, r and s the radii, rho = r + s. P = B (+) (-A), h(u) = max_b <u,b> - min_a
// <u,a> is its support function.
//     signed depth = rho + the least h(u)/|u| over all directions u It is the depth if it is
//     positive: no shorter translation makes the interiors disjoint. If it is negative, it is minus
//     the distance.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "fathom/point.hpp"
#include "fathom/shape.hpp"

namespace fathom {

// ---- vectors and points that are rational except for one length ----

/// The vector alpha normal + beta normal/|normal|.
struct AlongNormal {
  Vector normal;          ///< primitive
  mpq_class alpha, beta;  ///< beta: a length
  friend bool operator==(const AlongNormal&, const AlongNormal&) = default;
};

/// The point core + distance normal/|normal|: the core's point `core`, moved outward to the surface
/// of the body.
struct RoundedPoint {
  Point core;          ///< a point of the core
  Vector normal;       ///< of the answer's direction
  mpq_class distance;  ///< B: the radius; A: minus it
  friend bool operator==(const RoundedPoint&, const RoundedPoint&) = default;
};

/// A point of A and a point of B.
struct RoundedWitness {
  RoundedPoint a, b;  ///< of A, of B
  friend bool operator==(const RoundedWitness&, const RoundedWitness&) = default;
};

// ---- what is known of the cores ----

/// The linear space that a cone holds: O alone, a line, a plane, or everything.
enum class Lineality { none, line, plane, all };

/// All optimal directions of cores that touch, {u : h(u) = 0}: the sums of a vector of the
/// lineality and of multiples >= 0 of rays. In canonical form: two cones are equal if and only if
/// their members are.
struct OptimalCone {
  Lineality lineality = Lineality::none;  ///< the linear space in it
  Vector axis;  ///< primitive: of a line its direction, of a plane its normal, the lexicographically greater of the
                ///< two; else 0
  std::vector<Vector> rays;  ///< the extreme rays orthogonal to the lineality: primitive, sorted lexicographically
  /// One of them: the first ray. Without rays the lexicographically least of some: axis and -axis
  /// of a line; primitive vectors along the cross products of a plane's axis and the unit vectors,
  /// in both senses; (-1, 0, 0) of all.
  [[nodiscard]] Vector direction() const;
  friend bool operator==(const OptimalCone&, const OptimalCone&) = default;
};

/// A half-space against a polytope has one optimal direction: the half-space's normal if it is B,
/// the opposite one if it is A.
struct PlaneSupport {
  Vector direction;   ///< primitive
  mpq_class support;  ///< h(direction), of any sign
  Witness witness;    ///< b - a = (h(n) / <n,n>) n: a point of the polytope, and its foot point on the plane
};

/// A point of an atom: center + sum of local_i axes[i], |local|^2 <= 1.
struct AtomPoint {
  std::uint32_t atom;            ///< its index in the term
  std::vector<mpq_class> local;  ///< as many as the atom has axes
};

/// A point of a core: the sum of one point of each term, in their order.
using InnerPoint = std::vector<AtomPoint>;

/// A point of an atom of revolution about an axis d: center + z d + r e, for each e that is
/// orthogonal to d and as long. So z and r are lengths in multiples of |d|.
struct ProfilePlace {
  std::uint32_t atom;  ///< its index in the term
  mpq_class z, r;      ///< along the axis, and away from it: r >= 0
};

/// A point of a core's profile: the sum of one place of each term, in their order.
using ProfilePoint = std::vector<ProfilePlace>;

/// Proves a lower bound for cores of revolution about one axis, in a half-plane that ends there.
struct Revolution {
  Vector axis;                                   ///< d: primitive
  std::vector<ProfilePoint> points_a, points_b;  ///< to which the indices of the outline point
  /// Points of P, each the difference of a point of B and one of A: from the axis behind O around
  /// O to the axis before it. Each edge is at least as far from O as the bound says.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> outline;  ///< of points_a, of points_b
};

/// Proves bounds on the signed depth of any two shapes. For a half-space, heights and inner points
/// are empty; so are the inner points of cores around one axis.
struct Bracket {
  Vector direction;                          ///< n. (sum of all heights) / |n| + rho is at most the upper bound
  std::vector<mpq_class> heights_a;          ///< for each term of A, at least the greatest <-n,x> over its points
  std::vector<mpq_class> heights_b;          ///< for each term of B, at least the greatest <n,x>
  std::vector<InnerPoint> inner_a, inner_b;  ///< points of the cores, to which the indices of what follows point
  InnerPolytope polytope;                    ///< inside P, with O in its interior; or empty, and then there are
  /// convex combinations of inner points, whose distance bounds that of the cores
  std::vector<Weight> weights_a, weights_b;
  std::optional<Revolution> around{};  ///< or this, of cores of revolution about one axis that penetrate
  std::size_t support_calls = 0;       ///< no part of the proof: how often the search asked for the support of P
};

// ---- the answer ----

/// low <= value <= high, low < high.
struct Bounds {
  mpq_class low, high;  ///< rational
  friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// `value` is the answer, exact or enclosed; `core` says how it follows from the cores.
struct SignedDepth {
  std::variant<Surd, Bounds> value;  ///< see exact() and bounds()
  mpq_class radius_a, radius_b;      ///< of the two shapes
  /// of two polytopes; of a half-space and a polytope; of other shapes
  std::variant<Depth, PlaneSupport, Bracket> core;
  std::optional<OptimalCone> cone;    ///< if the cores are polytopes, or a half-space and a polytope, and touch
  std::optional<Contact> touching{};  ///< if the cores are polytopes and touch: see contact()

  /// Of the bodies, with their radii; nullopt if the bounds leave it open.
  [[nodiscard]] std::optional<Status> status() const;
  [[nodiscard]] const Surd* exact() const { return std::get_if<Surd>(&value); }       ///< null if the value is enclosed
  [[nodiscard]] const Bounds* bounds() const { return std::get_if<Bounds>(&value); }  ///< null if the value is exact
  /// The value, rounded outward: equal if and only if it is known and a double. Infinite beyond
  /// binary64.
  [[nodiscard]] double low_binary64() const;
  [[nodiscard]] double high_binary64() const;

  /// h(u)/|u| + rho is the value, or at most its upper bound, at u = direction(). Of cores that
  /// touch it is that of the cone.
  [[nodiscard]] Vector direction() const;
  /// Of bodies of revolution about one axis: its direction, if all directions are optimal that a
  /// turn about the axis makes of direction(). Null else. Where no optimal direction is rational an
  /// exact value has a direction() that is only near to one.
  [[nodiscard]] const Vector* around() const;
  /// For each listed optimum of overlapping cores, else for direction() alone: moving A by it makes
  /// bodies that penetrate touch, and so it does with disjoint bodies; no shorter translation does.
  /// Empty if the value is enclosed.
  [[nodiscard]] std::vector<AlongNormal> translations() const;
  /// Points of the bodies that belong to the first translation t: b - a = t. nullopt if the value
  /// is enclosed.
  [[nodiscard]] std::optional<RoundedWitness> witness() const;
  /// The faces of the cores in direction(), by the indices of the cores' points. Of cores that
  /// touch, those in any direction inside the cone, which are the least that share points. Null
  /// unless both cores are polytopes.
  [[nodiscard]] const Contact* contact() const;
  /// What the run did: of the depth of polytopes, or of the search for bounds.
  [[nodiscard]] Counters counters() const;
};

/// Bounds are not asked for more closely than to 2^-most_bound_bits.
inline constexpr unsigned most_bound_bits = 1000;

/// How to find a signed depth. Exact answers do not depend on it, except for the number of optima
/// that are listed.
struct SignedDepthOptions {
  Options cores;       ///< of the cores if both are polytopes; its monitor serves in any case
  unsigned bits = 40;  ///< bounds: to 2^-bits of the value or of the bodies' extent, <= most_bound_bits; to 2^-160 if
                       ///< the sign is open
  /// bounds: how often the cores' supports may be asked for; the bounds found until then are the
  /// answer
  std::size_t support_calls = 5000;
  /// Whether bodies of revolution about one axis are looked at in a half-plane that ends there: so
  /// they are answered exactly, or as closely as others. If not, the bounds are wider, and are what
  /// a certificate proves.
  bool coaxial = true;
};

/// A sum of terms that are hulls of points is a polytope, and expanded, if it has at most so many
/// points.
inline constexpr std::size_t most_expanded_points = 10'000;

/// Returns the signed depth of two shapes. A ball that is round, of rational radius and alone in
/// its term counts as a point and a radius, so that spheres are exact. Throws std::invalid_argument
/// if both are half-spaces, a core has no term or a term no atom, an atom has another number of
/// axes than 0, 2 and 3, a normal is 0, a radius negative, or a number not in lowest terms; for
/// bounds, if options.bits exceeds most_bound_bits; InputError if the numbers' denominators share
/// so little that it would take too much memory; and Interrupted.
SignedDepth signed_depth(const Shape& a, const Shape& b, const SignedDepthOptions& options = {});

}  // namespace fathom
