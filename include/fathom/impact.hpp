// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two convex polytopes, each with a rigid motion that turns and moves it.
// Output  when they meet first: apart throughout, or the two ends of a short interval in which the
//         first contact lies, with planes that prove that they are apart before.
//                                                                              [proofs/impact.md]
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/point.hpp"
#include "fathom/shape.hpp"

namespace fathom {

/// How a body moves while t goes from 0 to 1: its point x is at p(t) + R(t) x, where p(t) = (1 - t)
/// p0 + t p1 and R(t) is the rotation by q(t) = (1 - t) q0 + t q1, which is not normalised. Exact:
/// no root is taken. A body at rest has q0 = q1 and p0 = p1. q and -q are the same rotation, but
/// from q0 to -q1 a body turns the other way round.
struct RigidMotion {
  Quaternion q0{1, 0, 0, 0}, q1{1, 0, 0, 0};  ///< any but O; q(t) = O for no t in [0, 1]
  Point p0, p1;                               ///< where the origin of the body's frame is
};

/// The rotation and the place at t, exactly: q(t) and p(t). For any t at which q(t) is not O, else
/// std::invalid_argument.
Pose pose_at(const RigidMotion& motion, const mpq_class& t);

/// The points of a body where they are at t, exactly.
std::vector<Point> placed_at(std::span<const Point> points, const RigidMotion& motion, const mpq_class& t);

/// The motion that turns the shorter way: q1 is negated if q0.q1 < 0. Of two quaternions of one
/// rotation it is the motion without a turn.
RigidMotion shorter_way(RigidMotion motion);

/// A way to separate two bodies for a while: by planes orthogonal to a direction that turns with a
/// body, or that is orthogonal to a direction of each body.
struct MovingPlane {
  /// Which direction it is.
  enum class Kind : std::uint8_t {
    of_b,     ///< `first` in the frame of B, turned with B
    of_a,     ///< `first` in the frame of A, turned with A
    of_edges  ///< the cross product of `first`, in the frame of A, and `second`, in that of B, as they are turned
  };
  Kind kind;             ///< of the three
  Vector first, second;  ///< primitive; `second` only of_edges
  friend bool operator==(const MovingPlane&, const MovingPlane&) = default;
};
/// "face of B", "face of A" or "edges".
std::string_view name(MovingPlane::Kind kind);

/// The direction of the plane at t, primitive: it points from B to A. O where edges are
/// parallel.
Vector direction_at(const MovingPlane& plane, const RigidMotion& of_a, const RigidMotion& of_b, const mpq_class& t);

/// The bodies are near each other at the end of a short while in which they may touch.
struct NearMiss {
  mpq_class gap;             ///< at the end the distance is at most so much
  std::vector<Weight> a, b;  ///< convex weights of points that are so near
};

/// A part of the time, from the end of the part before, or from 0.
struct ImpactPiece {
  mpq_class until;                   ///< its end
  std::optional<MovingPlane> plane;  ///< that separates the bodies strictly at every time of it, both ends included
  std::optional<NearMiss> near;  ///< else: whether the bodies are apart within it is not known; at both ends they are
};

/// How the bodies meet first.
struct FirstContact {
  mpq_class t0;           ///< the bodies are apart at every t in [0, t0], but for near misses before
  mpq_class t1;           ///< t0 + 2^-bits: the bodies have a point in common
  std::vector<Weight> a;  ///< convex weights of the points of A: such a common point at t1
  std::vector<Weight> b;  ///< of the points of B: the same point
  Point point;            ///< that point, in the world
  Point in_a;             ///< the same in the frame of A
  Point in_b;             ///< and in that of B
  Vector normal;          ///< primitive, from B to A: of the plane that separates the bodies at t0
  Contact contact{};      ///< the faces of the bodies nearest to that plane at t0
};

/// What a motion comes to.
enum class ImpactStatus : std::uint8_t {
  apart,        ///< for all t in [0, 1]
  contact,      ///< first contact in [t0, t1]
  grazing,      ///< apart for all t in [0, 1], but for short whiles in which the bodies may touch
  at_beginning  ///< the bodies touch or penetrate at t = 0
};
/// "apart", "contact", "grazing" or "at the beginning".
std::string_view name(ImpactStatus status);

/// When two bodies meet.
struct Impact {
  ImpactStatus status = ImpactStatus::apart;  ///< which of the four
  std::vector<ImpactPiece> pieces;            ///< from 0 to 1, or to t0; none if the bodies meet at the beginning
  std::optional<FirstContact> contact;        ///< if `status` says so
  std::optional<Depth> beginning;             ///< at the beginning: the answer there, with the depth
  std::uint64_t questions = 0;                ///< how often the search asked where the bodies are apart at one time
};

/// Thrown if a motion needs more pieces of time than can be listed.
struct ImpactTooLong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What is asked for.
struct ImpactOptions {
  unsigned bits = 40;  ///< t0 and t1 are multiples of 2^-bits next to each other; 1 to 1000
  /// A while of 2^-bits in which the bodies come as near as this, and cannot be shown to be apart,
  /// is a near miss. 2^-bits of the extent of bodies and places unless given. > 0.
  std::optional<mpq_class> delta = std::nullopt;
  Monitor* monitor = nullptr;  ///< may watch and stop the search
};

/// Returns when two convex polytopes meet first, as closed bodies. Exact: t1 is the least multiple
/// of 2^-bits not before the first contact, however it was found, unless the bodies are apart there
/// again. Throws std::invalid_argument if a body is empty, a number is not in lowest terms, a
/// quaternion is O at some t in [0, 1] or an option is out of its range; ImpactTooLong if
/// the motion needs more than 100,000 pieces; and Interrupted.
Impact first_contact(std::span<const Point> a, const RigidMotion& of_a, std::span<const Point> b,
                     const RigidMotion& of_b, const ImpactOptions& options = {});

/// The text of its certificate: format 6 of verify/check/FORMAT.md; of bodies that meet at the
/// beginning that of the depth there. Throws as first_contact and certificate_text do.
std::string certificate_text(std::span<const Point> a, const RigidMotion& of_a, std::span<const Point> b,
                             const RigidMotion& of_b, const Impact& impact, std::string_view id = {},
                             Monitor* monitor = nullptr);

}  // namespace fathom
