// SPDX-License-Identifier: GPL-3.0-or-later
// Other depths of two bodies, and faster ones: along a direction, in a norm or gauge, within a
// factor 1 + delta, and shallow ones; and how far bodies grow about their centers until they touch.
//                                                                                [AGHRS, section 3]
// All of them shoot rays through P = B (+) (-A), which is never built: Dobkin-Kirkpatrick
// hierarchies of the two bodies find where a ray leaves it. Exact, for bodies of every rank. For
// bodies that do not penetrate, depths are a separating plane only: penetration_depth tells how far
// apart they are, growth_distance by which factor. What is said of penetration_depth's exceptions
// holds for all functions here; each adds its own.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/point.hpp"

namespace fathom {

// ---- along a direction ----

/// Where the ray from O leaves P.
struct RayExit {
  mpq_class factor;   ///< > 0, of the direction as given
  Point translation;  ///< factor * direction: moving A by it, no shorter way in this direction, makes the interiors
                      ///< disjoint
  Vector normal;      ///< primitive outward normal of the facet of P that the ray hits; of several facets, one
  Contact contact;    ///< in direction `normal`
  Witness witness;    ///< points of the contact with b - a = translation
  std::uint64_t steps = 0;  ///< in the hierarchies
};

/// How deep the bodies overlap along one direction.
struct DirectionalDepth : SeparationOr<RayExit> {
  /// 0 unless penetrating: the interiors are disjoint already.
  [[nodiscard]] mpq_class factor() const;
  [[nodiscard]] Point translation() const;
  /// |translation|^2.
  [[nodiscard]] mpq_class squared() const;
  /// Of the exit, or of the separation.
  [[nodiscard]] const Vector& normal() const;
};

/// Returns how far A must move along `direction`, which need not have length 1, until the interiors
/// are disjoint. Time: O(log^2(m + n)) steps after the hierarchies are built. Throws
/// std::invalid_argument if the direction is zero.
DirectionalDepth directional_depth(std::span<const Point> a, std::span<const Point> b, const Point& direction,
                                   Monitor* monitor = nullptr);

// ---- about two centers ----

/// Thrown for centers about which bodies need not touch, however they grow: center_b - center_a is
/// not in the interior of P. what() says where it is.
struct NoGrowth : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Where grown bodies touch, and the proof that they do not touch before. Below, c = center_b -
/// center_a, and h is the support function of P.
struct GrownTouch {
  Vector normal;    ///< primitive n with h(n) > <n,c> and <n,-c> = growth (h(n) - <n,c>): no smaller one has room
  Contact contact;  ///< in direction `normal`
  std::vector<Weight> weights_a, weights_b;  ///< convex weights of points of the two faces, by ascending index
  Witness witness;  ///< what they combine to: center_a + growth (a - center_a) = center_b + growth (b - center_b)
  std::uint64_t steps = 0;  ///< in the hierarchies
};

/// How far two bodies grow, or shrink, about their centers until they touch.
struct GrowthDistance : BodyFacts {
  /// >= 0, in lowest terms, without a unit: below 1 the bodies penetrate, at 1 they touch, above 1
  /// they are disjoint.
  mpq_class growth;
  Point center_a, center_b;         ///< as given, or the means of the bodies' corners
  std::optional<GrownTouch> touch;  ///< nullopt iff growth is 0: the centers coincide

  /// What the growth says of the bodies as they are.
  [[nodiscard]] Status status() const {
    if (growth < 1) return Status::penetrating;
    return growth == 1 ? Status::touching : Status::disjoint;
  }
};

/// Returns the growth distance: the least g >= 0 for which A, scaled by g about center_a, and B,
/// scaled by g about center_b, have a point in common. Exact, for bodies that penetrate, touch or
/// are apart. 1 / g is the factor of the ray through P from c to O and on. A center that is not
/// given is the mean of the body's corners, the points that are extreme, each once; finding them
/// takes a hull more. The centers need not lie in the bodies, but c must lie in the interior of P,
/// as it does for means unless P is flat. Throws NoGrowth otherwise, and std::invalid_argument if a
/// center is not in lowest terms. Time: that of directional_depth.
///                                                                       [proofs/ray.md, "Growth"]
GrowthDistance growth_distance(std::span<const Point> a, std::span<const Point> b,
                               const std::optional<Point>& center_a = std::nullopt,
                               const std::optional<Point>& center_b = std::nullopt, Monitor* monitor = nullptr);

// ---- in a norm or gauge ----

/// Thrown for a point set that is not a unit ball: its hull is flat, or does not have O in its
/// interior. what() says which.
struct NoUnitBall : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The unit ball Q, checked. Vertices are integer multiples of 1 / denominator.
struct UnitBall {
  std::vector<Vector> vertices;          ///< extreme points only
  std::vector<std::uint32_t> input_ids;  ///< of each vertex; of equal input points the lowest. Ascending.
  mpz_class denominator = 1;             ///< of the coordinates of the vertices, > 0
  bool symmetric = false;                ///< about O: a norm. Else a gauge: the length of -t may differ from that of t.
  unsigned dimension = 3;                ///< 2 of a ball of the plane: then every z is 0
};

/// Returns the convex hull of the points as a unit ball. Throws NoUnitBall, and
/// std::invalid_argument if there are no points.
UnitBall unit_ball(std::span<const Point> points);

/// A shortest way out in the metric of Q: along a vertex of Q.
struct MetricOptimum {
  std::uint32_t vertex;  ///< id of the input point of Q
  Point translation;     ///< depth times that vertex
  Vector direction;      ///< primitive outward normal of a facet of P that holds the translation
  Contact contact;       ///< in that direction
  Witness witness;       ///< points of the contact with b - a = translation
};

/// The depth in the metric of Q, with every shortest way out along a vertex of Q.
struct MetricPenetration {
  mpq_class depth;                    ///< > 0: the Q-length of each optimum's translation
  std::vector<MetricOptimum> optima;  ///< one per deciding vertex, by ascending id; at least one
  std::uint64_t rays = 0;             ///< that were shot
};

/// A depth in the metric of Q: a Q-length, not squared.
struct MetricResult : SeparationOr<MetricPenetration> {
  /// 0 unless penetrating.
  [[nodiscard]] mpq_class depth() const { return penetration() ? penetration()->depth : mpq_class(0); }
  /// Empty unless penetrating.
  [[nodiscard]] const std::vector<MetricOptimum>& optima() const;
  /// Of the first optimum, or of the separation.
  [[nodiscard]] const Vector& direction() const {
    return penetration() ? optima().front().direction : separation()->normal;
  }
};

/// Returns the exact Q-depth: the least s >= 0 such that some translation of A by a vector of s Q
/// makes the interiors disjoint. Time: a ray for each vertex of Q.
///                                                              [AGHRS, section 3.1, Corollary 3.4]
MetricResult metric_depth(std::span<const Point> a, std::span<const Point> b, const UnitBall& ball,
                          Monitor* monitor = nullptr);

// ---- within a factor ----

/// A depth within a known factor: bound <= the true depth <= |translation| <= (1 + delta) bound.
struct ApproxPenetration {
  mpq_class squared;        ///< |translation|^2
  mpq_class bound_squared;  ///< a lower bound of depth^2
  Vector direction;         ///< primitive outward normal of a facet of P: one, without a claim that it is an optimum
  Point translation;        ///< to the facet's plane, along the direction. Moving A by it makes the interiors disjoint
  Contact contact;          ///< in that direction
  std::optional<Witness> witness;     ///< nullopt if the foot of O on the facet's plane is not in the facet
  std::uint64_t rays = 0, steps = 0;  ///< rays that were shot, and their steps in the hierarchies
};

/// The depth within the factor 1 + delta.
struct ApproxDepth : SeparationOr<ApproxPenetration> {
  mpq_class delta;  ///< as it was asked for

  /// These three are 0 unless penetrating.
  [[nodiscard]] mpq_class squared() const { return penetration() ? penetration()->squared : mpq_class(0); }
  [[nodiscard]] mpq_class bound_squared() const { return penetration() ? penetration()->bound_squared : mpq_class(0); }
  [[nodiscard]] Point translation() const { return penetration() ? penetration()->translation : Point(); }
  /// Of the penetration, or of the separation.
  [[nodiscard]] const Vector& direction() const {
    return penetration() ? penetration()->direction : separation()->normal;
  }
};

/// Returns a separating translation at most 1 + delta times as long as the depth, which is exact in
/// itself. Time: O(1 / delta) rays. Throws std::invalid_argument if delta is below 1e-9.
///                                                          [AGHRS, APPROX-SEPARATION, Theorem 3.2]
ApproxDepth approx_depth(std::span<const Point> a, std::span<const Point> b, const mpq_class& delta,
                         Monitor* monitor = nullptr);

/// The same for the width of one body, as the depth of the body against itself, with half of the
/// rays.                                                                     [AGHRS, Corollary 3.3]
ApproxDepth approx_width(std::span<const Point> points, const mpq_class& delta, Monitor* monitor = nullptr);

// ---- shallow ----

/// Returns the exact depth with every optimum, and looks only at the facets of P near O: fast if
/// few facets are within (1 + delta) depth of O. The result is that of penetration_depth for every
/// delta, except that Depth::method is nullopt and the counters differ. Of the options it reads
/// `monitor`, `optima` and `validate`. Throws std::invalid_argument unless 0 < delta <= 2, or if
/// options.optima is 0.
///                                     [AGHRS, SHALLOW-PENETRATION, Theorem 3.5; proofs/shallow.md]
Depth shallow_depth(std::span<const Point> a, std::span<const Point> b, const Options& options = {},
                    const mpq_class& delta = mpq_class(1, 4));

// ---- bodies of the plane, and of space ----
//
// The same for polytopes, both of space, or both of the plane (fathom/plane.hpp): there every z is
// 0, that of directions, centers and balls too, and a contact is that of vertices and edges. Each
// throws std::invalid_argument as well if a body is no hull of points, or one of them is of the
// plane and another of space.                                                   [proofs/plane.md]

/// As the function of the same name about points.
DirectionalDepth directional_depth(const Body& a, const Body& b, const Point& direction, Monitor* monitor = nullptr);
/// As the function of the same name about points.
GrowthDistance growth_distance(const Body& a, const Body& b, const std::optional<Point>& center_a = std::nullopt,
                               const std::optional<Point>& center_b = std::nullopt, Monitor* monitor = nullptr);
/// The unit ball of a norm or gauge in space, or in the plane.
UnitBall unit_ball(const Body& body);
/// As the function of the same name about points, where also the ball is of the plane. In the plane
/// two rays more are shot.
MetricResult metric_depth(const Body& a, const Body& b, const UnitBall& ball, Monitor* monitor = nullptr);
/// As the functions of the same names about points, with as many rays in the plane as in space.
ApproxDepth approx_depth(const Body& a, const Body& b, const mpq_class& delta, Monitor* monitor = nullptr);
ApproxDepth approx_width(const Body& body, const mpq_class& delta, Monitor* monitor = nullptr);

// ---- many questions about the same bodies ----

class BodyPair;

/// Two bodies whose hierarchies are built once. Each answer equals that of the function of the same
/// name, which builds them anew. Many threads may ask one object at once.
class Hierarchies {
 public:
  /// throws as penetration_depth does
  Hierarchies(std::span<const Point> a, std::span<const Point> b, Monitor* monitor = nullptr);
  Hierarchies(Hierarchies&&) noexcept;             ///< the other one may only be assigned to, or destroyed
  Hierarchies& operator=(Hierarchies&&) noexcept;  ///< in the same way
  ~Hierarchies();
  /// As the function of the same name.
  [[nodiscard]] DirectionalDepth directional_depth(const Point& direction, Monitor* monitor = nullptr) const;
  [[nodiscard]] MetricResult metric_depth(const UnitBall& ball, Monitor* monitor = nullptr) const;
  [[nodiscard]] ApproxDepth approx_depth(const mpq_class& delta, Monitor* monitor = nullptr) const;

 private:
  std::unique_ptr<const BodyPair> pair_;
};

}  // namespace fathom
