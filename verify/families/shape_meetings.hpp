// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of shapes by inverse construction: first the contact, its direction and the signed depth are chosen, then the bodies are built
// around them.
//
// Each body is made under the plane z = 0, which it touches at O; A is then turned upside down and sunk into B by the depth g, and the pair
// is turned and moved. So h(n) = g for the normal n of the plane, and the points at O give a difference g n in P. If g <= 0 that is the
// signed depth. If g > 0: a ball inside A, of radius r, touches A's plane at its point, and so does one of radius s inside B. The depth of
// the balls is g as long as g <= r + s, and that of the bodies is no less.
#pragma once

#include "verify/families/random.hpp"
#include "verify/families/shape_pairs.hpp"

namespace fathom::families {

/// A body under the plane z = 0 that touches it at O, and the radius of a ball inside that touches it there too.
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
MeetingBody frustum_face(Random& random);
MeetingBody ellipsoid_pole(Random& random);
MeetingBody box_face(Random& random);
MeetingBody box_edge(Random& random);
MeetingBody box_vertex(Random& random);
MeetingBody rounded_box_edge(Random& random);
MeetingBody rounded_hull_vertex(Random& random);
MeetingBody sum_face(Random& random);  ///< of a cylinder and a box
MeetingBody plane(Random& random);     ///< of a half-space

/// Any of them but the plane.
MeetingBody any_side(Random& random);

/// Apart, touching, or overlapping as far as is proved above, by a hair or deeply. Numbers are rational. One of the two may be a plane.
NamedPair meeting(MakeMeetingBody first, MakeMeetingBody second, Random& random);

}  // namespace fathom::families
