// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies made ready for many rays: on one lattice, with the position of O, hulls and their
// hierarchies; then the ray, and the depth in another metric. [AGHRS, section 3]
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fathom/approximate.hpp"
#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "kernels/vector.hpp"
#include "reference/depth/apart.hpp"
#include "reference/polytope/hierarchy.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom {

/// Neither copied nor moved: hierarchies refer to hulls.
class BodyPair {
 public:
  /// Throws std::invalid_argument when a body is empty, and Interrupted.
  BodyPair(kernels::Context& context, std::span<const Point> a, std::span<const Point> b);
  BodyPair(const BodyPair&) = delete;
  BodyPair& operator=(const BodyPair&) = delete;

  [[nodiscard]] const polytope::PlacedPair& placed() const { return placed_; }
  [[nodiscard]] const BodyFacts& facts() const { return facts_; }
  /// nullopt if the bodies penetrate.
  [[nodiscard]] const std::optional<Separation>& separation() const { return separation_; }

  // The rest only if penetrating.

  [[nodiscard]] const polytope::Hierarchy& a() const { return solid_->hierarchy_a; }
  [[nodiscard]] const polytope::Hierarchy& b() const { return solid_->hierarchy_b; }
  /// factor * u, from the lattice's unit to that of the input.
  [[nodiscard]] Point translation(const mpq_class& factor, const Vector& u) const;
  /// The contact in direction n, the outward normal of a facet of P, and points a and b of it with
  /// b - a = t: nullopt if the faces moved by t do not meet.
  struct Meeting {
    Contact contact;
    std::optional<Witness> witness;
  };
  [[nodiscard]] Meeting meeting(const Vector& n, const Point& t) const;

 private:
  struct Solid {
    explicit Solid(depth::Hulls of_both) : hulls(std::move(of_both)), hierarchy_a(hulls.a), hierarchy_b(hulls.b) {}
    depth::Hulls hulls;
    polytope::Hierarchy hierarchy_a, hierarchy_b;
  };

  polytope::PlacedPair placed_;
  BodyFacts facts_;
  std::optional<Separation> separation_;
  std::unique_ptr<const Solid> solid_;
};

/// Checks the growth by the definitions, in rationals and over all points: that the weights make
/// the grown bodies touch, and that the normal forbids it for less.
[[nodiscard]] kernels::Report validate(const GrowthDistance& found, std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom

// Input   hierarchies of two convex polytopes A and B; a direction, not zero; a point in place of
//         O.
// Output  where the ray from that point leaves P = B (+) (-A), as an exact factor of the direction,
//         and a facet of P that it leaves through. P is never built.             [AGHRS, section 3]
// Time    O(log^2 (m + n)) steps a ray, whatever the shapes, where m and n count vertices; as a
//         rule some 10 to 30 support queries of P, each O(log m + log n).           [proofs/ray.md]

namespace fathom::approximate {

inline constexpr std::uint64_t rays_between_reports = 64;

/// Below, h(u) = max_b <u,b> - min_a <u,a> is the support function of P.
struct RayHit {
  /// Whether the start lies in P, inside or on the boundary. If not, the factor is 0, and `normal`
  /// and `height` prove it: <normal, start> > height.
  bool hits = false;
  bool interior = false;  ///< whether the start lies in the interior of P
  /// The greatest f with start + f direction in P: exact, >= 0; 0 where the ray leaves P at once,
  /// and always when P is flat.
  mpq_class factor;
  /// Primitive outward normal n of a facet of P that holds the hit point, with <n, direction> > 0.
  /// When P is flat, the normal of a plane that holds P, with <n, direction> >= 0.
  Vector normal;
  mpz_class height;           ///< h(normal)
  std::uint64_t queries = 0;  ///< support queries of P
  polytope::Steps steps = 0;  ///< steps of the hierarchies in these queries
};

struct SupportOfSum;

/// Shoots many rays through the same bodies: computes once what does not depend on the ray. The
/// hierarchies must outlive it. Exact for integers of any size; bodies of any rank.
class RayShooter {
 public:
  RayShooter(const polytope::Hierarchy& a, const polytope::Hierarchy& b);
  /// After `patience` support queries a search becomes a descent of both hierarchies, which takes
  /// O(log m log n) steps whatever the shapes, but more than a usual search. Answers do not depend
  /// on it.
  RayShooter(const polytope::Hierarchy& a, const polytope::Hierarchy& b, std::uint64_t patience);

  /// From `start`, in lattice units. Moving A by t moves P by -t: shoot from t instead; nothing is
  /// prepared anew. Throws std::invalid_argument when the direction is zero.
  [[nodiscard]] RayHit shoot(const Vector& direction, const Vector& start = {0, 0, 0}) const;

  /// Of P.
  [[nodiscard]] int rank() const { return 3 - static_cast<int>(thickness_.size()); }

 private:
  [[nodiscard]] RayHit shoot_solid(const Vector& direction, const Vector& start, SupportOfSum& support) const;
  [[nodiscard]] RayHit shoot_flat(const Vector& direction, const Vector& start, SupportOfSum& support) const;

  const polytope::Hierarchy* a_;
  const polytope::Hierarchy* b_;
  std::uint64_t patience_;
  /// A basis of the directions orthogonal to P; empty for a solid P. A flat P is thickened by the
  /// segments from -t to t.
  std::vector<Vector> thickness_;
  /// Affinely independent points of 4 P, thickened.
  std::array<Vector, 4> corners_;
};

/// Shoots one ray.
RayHit shoot_ray(const polytope::Hierarchy& a, const polytope::Hierarchy& b, const Vector& direction,
                 const Vector& start = {0, 0, 0});

// Input   two bodies, and a convex polytope Q with O in its interior: the unit ball of a norm if Q
//         is symmetric about O, else of a gauge.
// Output  the exact Q-depth: the least s >= 0 such that some translation of A by a vector of s Q
//         makes the interiors disjoint. [AGHRS, section 3.1, Corollary 3.4]
// Time    one ray of O(log^2(m + n)) steps for each of Q's k vertices, once the hierarchies stand.

/// In integers: vertices of the ball and points of the lattice as they are.
struct MetricDepth {
  bool inside = false;     ///< whether O is in P, its boundary included. If not, no other field is set.
  mpq_class depth;         ///< in multiples of ball.vertices, taken as integer vectors of the lattice
  std::uint64_t rays = 0;  ///< shot
  /// Vertices of the ball whose rays leave P first, ascending. Empty when the depth is 0.
  struct Deciding {
    std::uint32_t vertex;
    Vector normal;  ///< primitive outward normal of a facet of P that holds the hit point
  };
  std::vector<Deciding> deciding;
};

/// P = B (+) (-A), seen from the point `shift` of the lattice in place of O: A moved by `shift`,
/// without new hierarchies.
MetricDepth metric_depth(kernels::Context& context, const polytope::Hierarchy& a, const polytope::Hierarchy& b,
                         const UnitBall& ball, const Vector& shift = {0, 0, 0});

}  // namespace fathom::approximate
