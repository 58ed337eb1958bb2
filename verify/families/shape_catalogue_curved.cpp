// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies with discs and balls: cylinders, cones, frusta, ellipsoids; and margins and sums.
#include "verify/families/shape_catalogue_groups.hpp"

namespace fathom::families {
namespace {

NamedBody drum(const mpq_class& radius = 1, const mpq_class& half_length = 1, Axis axis = Axis::z) {
  return of_lengths("cylinder", radius, half_length, axis);
}

/// Its axis leans by the angle with cosine 4/5: its lowest point is 7/5 under its centre.
NamedBody leaning_drum() { return posed(drum(), {3, 0, 1, 0}, {}); }

/// Radius 3, height 4: its generators have length 5, and the normal (4, 0, 3)/5 is that of one of them.
NamedBody hat() { return of_lengths("cone", 3, 2); }

/// All on the far side of a plane with normal (4, 0, 3).
NamedBody slope(const mpq_class& offset) {
  return named("halfspace", {{"normal", {mpq_class(-4), mpq_class(0), mpq_class(-3)}}, {"offset", {-offset}}});
}

}  // namespace

ShapeEntries cylinder_entries() {
  const mpq_class half(1, 2), quarter(1, 4);
  const NamedBody floor = block_of(4, 4, 1);
  return {
      shapes("cylinder_standing_on_box", "a cylinder stands on a box", rational(0), at(drum(), {0, 0, 2}), floor),
      shapes("cylinder_standing_over_edge", "a cylinder stands on a box, and its axis meets an edge", rational(0), at(drum(), {4, 0, 2}),
             floor),
      shapes("cylinder_one_ulp_above_box", "a cylinder stands one ulp above a box", rational(2 - above_two()),
             at(drum(), {0, 0, above_two()}), floor),
      shapes("cylinder_one_ulp_in_box", "a cylinder stands one ulp deep in a box", rational(2 - below_two()),
             at(drum(), {0, 0, below_two()}), floor),
      shapes("cylinder_sunk_in_box", "a cylinder stands a quarter deep in a box", rational(quarter), at(drum(), {0, 0, 2 - quarter}),
             floor),
      shapes("cylinder_lying_on_box", "a cylinder lies on a box", rational(0), at(drum(1, 1, Axis::x), {0, 0, 2}), floor),
      shapes("cylinder_lying_in_box", "a cylinder lies a quarter deep in a box", rational(quarter),
             at(drum(1, 1, Axis::x), {0, 0, 2 - quarter}), floor),
      shapes("cylinder_standing_on_plane", "a cylinder stands on a plane", rational(0), at(drum(), {0, 0, 1}), ground()),
      shapes("cylinder_lying_on_plane", "a cylinder lies on a plane", rational(0), at(drum(1, 1, Axis::y), {0, 0, 1}), ground()),
      shapes("cylinder_under_plane", "a cylinder is far below a plane", rational(6), at(drum(), {0, 0, -5}), ground()),
      shapes("rim_on_plane", "a leaning cylinder stands on a plane by one point of its rim", rational(0),
             at(leaning_drum(), {0, 0, mpq_class(7, 5)}), ground()),
      shapes("rim_on_face", "a leaning cylinder stands on a box by one point of its rim", rational(0),
             at(leaning_drum(), {0, 0, mpq_class(12, 5)}), floor),
      shapes("rim_in_face", "the rim of a leaning cylinder is a quarter deep in a box", rational(quarter),
             at(leaning_drum(), {0, 0, mpq_class(12, 5) - quarter}), floor),
      shapes("rim_on_rim", "the end faces of two cylinders share exactly one point, of both rims", rational(0), drum(),
             at(drum(), {2, 0, 2})),
      shapes("cylinders_equal", "the same cylinder twice", rational(1), drum(1, half), drum(1, half)),
      shapes("cylinders_coaxial", "cylinders about one axis, one inside the other: every direction across it is optimal",
             rational(mpq_class(3, 2)), drum(1, 2), drum(half)),
      shapes("cylinders_end_to_end", "cylinders on one axis touch with their end faces", rational(0), drum(1, 2),
             at(drum(half), {0, 0, 3})),
      shapes("cylinders_side_by_side", "parallel cylinders touch along a generator", rational(0), drum(),
             at(drum(half), {mpq_class(3, 2), 0, half})),
      shapes("cylinders_crossed", "cylinders touch across each other", rational(0), drum(1, 2),
             at(drum(half, 2, Axis::x), {0, mpq_class(3, 2), 0})),
      shapes("cylinders_crossed_deep", "cylinders across each other, a quarter deep", rational(quarter), drum(1, 2),
             at(drum(half, 2, Axis::x), {0, mpq_class(5, 4), 0})),
      shapes("cylinder_axis_on_sphere", "the centre of a sphere is that of a cylinder", rational(mpq_class(3, 2)), ball(half), drum()),
      shapes("cylinder_on_capsule", "a capsule lies on the end face of a cylinder", rational(0), drum(),
             at(of_lengths("capsule", quarter, 2, Axis::x), {0, 0, 1 + quarter})),
  };
}

ShapeEntries cone_entries() {
  const mpq_class quarter(1, 4);
  const NamedBody floor = block_of(2, 2, 1), tip = upside_down(of_lengths("cone", 1, 1));
  return {
      shapes("apex_on_plane", "a cone stands on its apex", rational(0), at(tip, {0, 0, 1}), ground()),
      shapes("apex_on_face", "a cone stands on a box by its apex", rational(0), at(tip, {0, 0, 2}), floor),
      shapes("apex_in_face", "the apex of a cone is a quarter deep in a box", rational(quarter), at(tip, {0, 0, 2 - quarter}), floor),
      shapes("apex_on_apex", "two cones touch in their apexes", rational(0), at(tip, {0, 0, 1}), at(of_lengths("cone", 1, 1), {0, 0, -1})),
      shapes("cone_standing_on_box", "a cone stands on a box", rational(0), at(of_lengths("cone", 1, 1), {0, 0, 2}), floor),
      shapes("cone_lying_on_plane", "a cone lies on a plane along a generator", rational(0), hat(), slope(6)),
      shapes("cones_along_generators", "two cones, one upside down, touch along a generator of both", rational(0), hat(),
             at(upside_down(hat()), {3, 0, 0})),
      shapes("cones_along_generators_deep", "two cones, one upside down, a quarter deep along a generator of both", rational(quarter),
             hat(), at(upside_down(hat()), {mpq_class(14, 5), 0, mpq_class(-3, 20)})),
      shapes("cones_equal", "the same cone twice: it is 4 high, and 24/5 wide across a generator", rational(4), hat(), hat()),
      shapes("cone_in_cone", "a cone in a similar one twice as large, with the same apex and axis", rational(4), of_lengths("cone", 6, 4),
             at(hat(), {0, 0, 2})),
      shapes("cone_in_cylinder", "a cone fills a cylinder of its own height", rational(4), of_lengths("cylinder", 3, 2), hat()),
      shapes("frustum_on_frustum", "a frustum stands on the smaller end face of another", rational(0),
             at(of_ends("frustum", 2, 1, 1), {0, 0, 2}), of_ends("frustum", 2, 1, 1)),
      shapes("frustum_on_plane", "a frustum lies on a plane along a generator", rational(0), of_ends("frustum", 4, 1, 2), slope(10)),
  };
}

ShapeEntries other_entries() {
  const mpq_class half(1, 2), quarter(1, 4);
  const NamedBody egg = ellipsoid_of(1, 2, 3);
  return {
      shapes("ellipsoid_on_plane", "an ellipsoid stands on a plane by its pole", rational(0), at(egg, {0, 0, 3}), ground()),
      shapes("ellipsoid_on_box", "an ellipsoid lies on a box by its flattest point", rational(0), at(egg, {2, 0, 0}), block_of(1, 1, 1)),
      shapes("ellipsoids_at_poles", "two ellipsoids touch in poles of different curvature", rational(0), egg,
             at(ellipsoid_of(3, 2, 1), {0, 0, 4})),
      shapes("ellipsoid_in_sphere", "a sphere and an ellipsoid about one centre", rational(4), ball(3), egg),
      shapes("ellipsoid_in_box", "a box and an ellipsoid about one centre", rational(mpq_class(5, 4)), block_of(1, 1, 1),
             ellipsoid_of(quarter, half, mpq_class(3, 4))),
      shapes("tapered_capsule_on_plane", "a hull of two balls lies on a plane along a generator", rational(0),
             of_ends("tapered_capsule", 4, 1, mpq_class(5, 2)), slope(mpq_class(25, 2))),
      shapes("tapered_capsule_on_box", "a hull of two balls stands on a box", rational(0),
             at(of_ends("tapered_capsule", 2, 1, 3), {0, 0, 6}), block_of(1, 1, 1)),
      shapes("margins_touching", "two boxes with margins touch: their cores are a half apart", {half, ratio(-1, 4)},
             rounded(block_of(half, half, half), quarter), at(rounded(block_of(half, half, half), quarter), {mpq_class(3, 2), 0, 0})),
      shapes("margins_at_equality", "parallel edges of two boxes are 5 apart, the sum of the margins", {5, -25},
             rounded(block_of(1, 1, 1), 2), at(rounded(block_of(1, 1, 1), 3), {5, 6, half})),
      shapes("margin_of_nothing", "a margin of 0 changes nothing: two boxes share a face", rational(0), rounded(block_of(1, 1, 1), 0),
             at(block_of(1, 1, 1), {2, half, 0})),
      shapes("rounded_cylinder_on_plane", "a cylinder with a margin stands on a plane", rational(0),
             at(rounded(drum(), quarter), {0, 0, 1 + quarter}), ground()),
      shapes("sum_on_plane", "the sum of a cylinder and a cube stands on a plane", rational(0),
             at(named_sum({drum(), block_of(1, 1, 1)}), {0, 0, 2}), ground()),
      shapes("sums_touching", "sums of a cylinder and a cube stand on each other", rational(0), named_sum({drum(), block_of(1, 1, 1)}),
             at(named_sum({drum(half), block_of(half, half, half)}), {0, 0, mpq_class(7, 2)})),
  };
}

}  // namespace fathom::families
