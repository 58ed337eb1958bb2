// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of shapes: two bodies by their names, and what is known of the answer; at random, and from
// their contact.  [docs/shapes.md]
#pragma once

#include <optional>
#include <string>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/families/random.hpp"

namespace fathom::families {

using files::named;
using files::named_hull;
using files::named_sum;
using files::NamedBody;
using files::posed;
using files::rounded;
using files::shape_of;

/// The part of the answer that is known by construction.
struct KnownDepth {
  Surd signed_depth;
  std::optional<Point> direction = std::nullopt;  ///< one that attains it, of length 1
};

/// Two bodies that have no id yet.
struct NamedPair {
  NamedBody a, b;
  std::optional<KnownDepth> known = std::nullopt;
};

struct ShapeCase {
  std::string id;
  NamedPair pair;

  /// Returns the bodies as a reader of the printed case gets them.
  [[nodiscard]] Case read() const { return {id, files::body_of(pair.a), files::body_of(pair.b)}; }
};

// ---- random pairs, whose numbers all are binary64, so that programs in doubles can take them as
// they are ----

enum class ShapeKind {
  sphere,
  capsule,
  tapered_capsule,
  box,
  rounded_box,
  cylinder,
  rounded_cylinder,
  cone,
  rounded_cone,
  frustum,
  ellipsoid,
  hull,
  rounded_hull,
  rounded_triangle,
  sum
};
inline constexpr int shape_kinds = static_cast<int>(ShapeKind::sum) + 1;

ShapeKind random_kind(Random& random);

/// Bodies of about unit size that overlap deeply, slightly, or are apart, by a hair or by far; a
/// fifth touch. Those that touch, and some of the others, are turned by symmetries of the cube, so
/// that faces and axes are parallel. A hull has `n` points, at least 4.
NamedPair random_pair(ShapeKind a, ShapeKind b, Random& random, unsigned n);

/// The same for two hulls that depend on n alone: only the poses are random.
NamedPair prepared_hulls(Random& random, unsigned n);

/// The same with every length of the bodies up to 256 times larger or smaller.
NamedPair stretched_pair(ShapeKind a, ShapeKind b, Random& random, unsigned n);

/// A body against a half-space; either may be the first.
NamedPair random_pair_with_plane(ShapeKind kind, Random& random, unsigned n);

// ---- inverse construction ----

// Pairs of shapes by inverse construction: first the contact, its direction and the signed depth
// are chosen, then the bodies are built around them.
//
// Each body is made under the plane z = 0, which it touches at O; A is then turned upside down and
// sunk into B by the depth g, and the pair is turned and moved. So h(n) = g for the normal n of the
// plane, and the points at O give a difference g n in P. If g <= 0 that is the signed depth. If g >
// 0: a ball inside A, of radius r, touches A's plane at its point, and so does one of radius s
// inside B. The depth of the balls is g as long as g <= r + s, and that of the bodies is no less.

/// A body under the plane z = 0 that touches it at O, and the radius of a ball inside that touches
/// it there too.
struct MeetingBody {
  NamedBody body;
  mpq_class inner;
};
using MakeMeetingBody = MeetingBody (*)(Random&);

MeetingBody sphere_cap(Random& random);
MeetingBody capsule_cap(Random& random);
MeetingBody capsule_side(Random& random);
MeetingBody tapered_side(Random& random);  ///< a tapered capsule by a generator
MeetingBody cylinder_face(Random& random);
MeetingBody cylinder_barrel(Random& random);
MeetingBody cylinder_rim(Random& random);
MeetingBody cone_base(Random& random);
MeetingBody cone_apex(Random& random);
MeetingBody cone_generator(Random& random);
MeetingBody ellipsoid_pole(Random& random);
MeetingBody box_face(Random& random);
MeetingBody box_edge(Random& random);
MeetingBody box_vertex(Random& random);
MeetingBody rounded_box_edge(Random& random);
MeetingBody plane(Random& random);  ///< of a half-space

/// Any of them but the plane.
MeetingBody any_side(Random& random);

/// Apart, touching, or overlapping as far as is proved above, by a hair or deeply. Numbers are
/// rational. One of the two may be a plane.
NamedPair meeting(MakeMeetingBody first, MakeMeetingBody second, Random& random);

}  // namespace fathom::families
