// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue of pairs of shapes, group by group.
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "verify/families/families.hpp"
#include "verify/families/random.hpp"
#include "verify/families/union_pairs.hpp"

namespace fathom::families {

namespace {

ShapeCatalogueEntry shapes(std::string name, std::string_view description, Surd signed_depth, NamedBody a,
                           NamedBody b) {
  return {description, {std::move(name), {std::move(a), std::move(b), KnownDepth{std::move(signed_depth)}}}};
}

Surd rational(mpq_class value) { return {std::move(value), 0}; }

NamedBody ball(const mpq_class& radius) { return named("sphere", {{"radius", {radius}}}); }
NamedBody block_of(const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return named("box", {{"half", {x, y, z}}});
}
NamedBody ellipsoid_of(const mpq_class& x, const mpq_class& y, const mpq_class& z) {
  return named("ellipsoid", {{"radii", {x, y, z}}});
}
NamedBody of_lengths(const char* shape, const mpq_class& radius, const mpq_class& half_length, Axis axis = Axis::z) {
  return named(shape, {{"radius", {radius}}, {"half_length", {half_length}}}, axis);
}
NamedBody of_ends(const char* shape, const mpq_class& low, const mpq_class& high, const mpq_class& half_length) {
  return named(shape, {{"radius_low", {low}}, {"radius_high", {high}}, {"half_length", {half_length}}});
}
/// The half-space z <= 0.
NamedBody ground() {
  return named("halfspace", {{"normal", {mpq_class(0), mpq_class(0), mpq_class(1)}}, {"offset", {mpq_class(0)}}});
}
NamedBody at(NamedBody body, const Point& place) { return posed(std::move(body), {1, 0, 0, 0}, place); }
NamedBody upside_down(NamedBody body) { return posed(std::move(body), {0, 1, 0, 0}, {}); }

/// The binary64 numbers next to 2.
mpq_class above_two() { return 2 + times_power_of_two(1, -51); }
mpq_class below_two() { return 2 - times_power_of_two(1, -52); }

using ShapeEntries = std::vector<ShapeCatalogueEntry>;

// ---- balls and capsules ----

NamedBody pill(const mpq_class& radius, Axis axis = Axis::z) { return of_lengths("capsule", radius, 1, axis); }

NamedBody flat_triangle() {
  NamedBody body{"triangle"};
  body.fields.vertices = {{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}};
  return body;
}

ShapeEntries ball_entries() {
  const mpq_class half(1, 2);
  const mpq_class below_root = exact_value(0x1.6a09e667f3bccp-1),
                  above_root = exact_value(0x1.6a09e667f3bcdp-1);  // of 1/2
  return {
      shapes("spheres_concentric", "spheres about one centre: every direction is optimal", rational(3), ball(1),
             ball(2)),
      shapes("spheres_touching", "two spheres touch", rational(0), ball(1), at(ball(1), {2, 0, 0})),
      shapes("spheres_at_equality", "the sum of the radii, 5, is the distance of the centres", {5, -25}, ball(2),
             at(ball(3), {3, 4, 0})),
      shapes("spheres_one_ulp_deep", "a radius is one ulp larger than where they touch", {above_two() + 3, -25},
             ball(above_two()), at(ball(3), {3, 4, 0})),
      shapes("spheres_one_ulp_apart", "a radius is one ulp smaller than where they touch", {below_two() + 3, -25},
             ball(below_two()), at(ball(3), {3, 4, 0})),
      shapes("spheres_above_a_root",
             "the distance is the root of 2, and the radii are the doubles just above half of it", {2 * above_root, -2},
             ball(above_root), at(ball(above_root), {1, 1, 0})),
      shapes("spheres_below_a_root",
             "the distance is the root of 2, and the radii are the doubles just below half of it", {2 * below_root, -2},
             ball(below_root), at(ball(below_root), {1, 1, 0})),
      shapes("sphere_on_plane", "a sphere lies on a plane", rational(0), at(ball(1), {0, 0, 1}), ground()),
      shapes("sphere_centre_on_plane", "the centre of a sphere is on a plane", rational(1), ball(1), ground()),
      shapes("sphere_on_box", "a sphere lies on a box", rational(0), at(ball(1), {half, 0, 2}), block_of(1, 1, 1)),
      shapes("sphere_centre_on_face", "the centre of a sphere is on a face", rational(half), at(ball(half), {0, 0, 1}),
             block_of(1, 1, 1)),
      shapes("sphere_centre_on_edge", "the centre of a sphere is on an edge: a fan of optimal directions",
             rational(half), at(ball(half), {0, 1, 1}), block_of(1, 1, 1)),
      shapes("sphere_centre_on_vertex", "the centre of a sphere is a vertex: an octant of optimal directions",
             rational(half), at(ball(half), {1, 1, 1}), block_of(1, 1, 1)),
      shapes("sphere_centre_in_triangle", "the centre of a sphere is in a triangle, which is flat", rational(half),
             ball(half), flat_triangle()),
      shapes("sphere_under_vertex", "the tip of a pyramid touches a sphere", rational(0), ball(1),
             named_hull({{0, 0, 1}, {2, 2, 3}, {-2, 2, 3}, {-2, -2, 3}, {2, -2, 3}})),
      shapes("ball_that_is_an_ellipsoid", "an ellipsoid with three equal radii against the same sphere", rational(1),
             ball(1), at(ellipsoid_of(1, 1, 1), {1, 0, 0})),
  };
}

ShapeEntries capsule_entries() {
  const mpq_class half(1, 2), quarter(1, 4);
  const NamedBody a = pill(quarter);
  return {
      shapes("capsules_equal", "the same capsule twice: every direction across the axis is optimal", rational(half), a,
             a),
      shapes("capsules_coaxial", "capsules about one axis, one inside the other", rational(1), a,
             of_lengths("capsule", mpq_class(3, 4), 2)),
      shapes("capsules_end_to_end", "capsules on one axis touch with their ends", rational(0), a,
             at(a, {0, 0, mpq_class(5, 2)})),
      shapes("capsules_crossing", "the axes cross: the normal of their plane and its opposite are optimal",
             rational(half), a, pill(quarter, Axis::x)),
      shapes("capsules_across", "capsules touch across each other", rational(0), a,
             at(pill(quarter, Axis::x), {0, half, 0})),
      shapes("capsules_axis_on_end", "an end of one axis is on the other axis", rational(half), a,
             at(pill(quarter, Axis::x), {1, 0, half})),
      shapes("capsules_parallel_touching", "parallel capsules touch along a segment", rational(0), a,
             at(a, {half, 0, half})),
      shapes("capsules_parallel_deep", "parallel capsules overlap", rational(quarter), a, at(a, {quarter, 0, half})),
      shapes("capsules_at_equality", "the sum of the radii of parallel capsules is the distance of their axes",
             {5, -25}, pill(2), at(pill(3), {3, 4, half})),
      shapes("capsules_one_ulp_deep", "a radius is one ulp larger than where they touch", {above_two() + 3, -25},
             pill(above_two()), at(pill(3), {3, 4, half})),
      shapes("capsules_one_ulp_apart", "a radius is one ulp smaller than where they touch", {below_two() + 3, -25},
             pill(below_two()), at(pill(3), {3, 4, half})),
      shapes("sphere_centre_on_segment", "the centre of a sphere is on the axis of a capsule",
             rational(mpq_class(3, 4)), at(ball(half), {0, 0, half}), a),
      shapes("sphere_centre_on_end", "the centre of a sphere is an end of the axis of a capsule",
             rational(mpq_class(3, 4)), at(ball(half), {0, 0, 1}), a),
      shapes("capsule_standing_on_plane", "a capsule stands on a plane", rational(0), at(a, {0, 0, mpq_class(5, 4)}),
             ground()),
      shapes("capsule_lying_on_plane", "a capsule lies on a plane", rational(0),
             at(pill(quarter, Axis::y), {0, 0, quarter}), ground()),
      shapes("capsule_lying_on_box", "a capsule lies on a box, and juts out", rational(0),
             at(pill(quarter, Axis::y), {0, 1, 1 + quarter}), block_of(1, 1, 1)),
      shapes("capsule_along_edge", "the axis of a capsule lies in an edge of a box", rational(quarter),
             at(a, {1, 1, 0}), block_of(1, 1, 1)),
  };
}

// ---- bodies with discs and balls: cylinders, cones, frusta, ellipsoids; margins and sums ----

NamedBody drum(const mpq_class& radius = 1, const mpq_class& half_length = 1, Axis axis = Axis::z) {
  return of_lengths("cylinder", radius, half_length, axis);
}

/// Its axis leans by the angle with cosine 4/5: its lowest point is 7/5 under its centre.
NamedBody leaning_drum() { return posed(drum(), {3, 0, 1, 0}, {}); }

/// Radius 3, height 4: its generators have length 5, and the normal (4, 0, 3)/5 is that of one of
/// them.
NamedBody hat() { return of_lengths("cone", 3, 2); }

/// The half-space on the far side of a plane with normal (4, 0, 3).
NamedBody slope(const mpq_class& offset) {
  return named("halfspace", {{"normal", {mpq_class(-4), mpq_class(0), mpq_class(-3)}}, {"offset", {-offset}}});
}

ShapeEntries cylinder_entries() {
  const mpq_class half(1, 2), quarter(1, 4);
  const NamedBody floor = block_of(4, 4, 1);
  return {
      shapes("cylinder_standing_on_box", "a cylinder stands on a box", rational(0), at(drum(), {0, 0, 2}), floor),
      shapes("cylinder_standing_over_edge", "a cylinder stands on a box, and its axis meets an edge", rational(0),
             at(drum(), {4, 0, 2}), floor),
      shapes("cylinder_one_ulp_above_box", "a cylinder stands one ulp above a box", rational(2 - above_two()),
             at(drum(), {0, 0, above_two()}), floor),
      shapes("cylinder_one_ulp_in_box", "a cylinder stands one ulp deep in a box", rational(2 - below_two()),
             at(drum(), {0, 0, below_two()}), floor),
      shapes("cylinder_sunk_in_box", "a cylinder stands a quarter deep in a box", rational(quarter),
             at(drum(), {0, 0, 2 - quarter}), floor),
      shapes("cylinder_lying_on_box", "a cylinder lies on a box", rational(0), at(drum(1, 1, Axis::x), {0, 0, 2}),
             floor),
      shapes("cylinder_lying_in_box", "a cylinder lies a quarter deep in a box", rational(quarter),
             at(drum(1, 1, Axis::x), {0, 0, 2 - quarter}), floor),
      shapes("cylinder_standing_on_plane", "a cylinder stands on a plane", rational(0), at(drum(), {0, 0, 1}),
             ground()),
      shapes("cylinder_lying_on_plane", "a cylinder lies on a plane", rational(0), at(drum(1, 1, Axis::y), {0, 0, 1}),
             ground()),
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
      shapes("cylinders_coaxial",
             "cylinders about one axis, one inside the other: every direction across it is optimal",
             rational(mpq_class(3, 2)), drum(1, 2), drum(half)),
      shapes("cylinders_end_to_end", "cylinders on one axis touch with their end faces", rational(0), drum(1, 2),
             at(drum(half), {0, 0, 3})),
      shapes("cylinders_side_by_side", "parallel cylinders touch along a generator", rational(0), drum(),
             at(drum(half), {mpq_class(3, 2), 0, half})),
      shapes("cylinders_crossed", "cylinders touch across each other", rational(0), drum(1, 2),
             at(drum(half, 2, Axis::x), {0, mpq_class(3, 2), 0})),
      shapes("cylinders_crossed_deep", "cylinders across each other, a quarter deep", rational(quarter), drum(1, 2),
             at(drum(half, 2, Axis::x), {0, mpq_class(5, 4), 0})),
      shapes("cylinder_axis_on_sphere", "the centre of a sphere is that of a cylinder", rational(mpq_class(3, 2)),
             ball(half), drum()),
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
      shapes("apex_in_face", "the apex of a cone is a quarter deep in a box", rational(quarter),
             at(tip, {0, 0, 2 - quarter}), floor),
      shapes("apex_on_apex", "two cones touch in their apexes", rational(0), at(tip, {0, 0, 1}),
             at(of_lengths("cone", 1, 1), {0, 0, -1})),
      shapes("cone_standing_on_box", "a cone stands on a box", rational(0), at(of_lengths("cone", 1, 1), {0, 0, 2}),
             floor),
      shapes("cone_lying_on_plane", "a cone lies on a plane along a generator", rational(0), hat(), slope(6)),
      shapes("cones_along_generators", "two cones, one upside down, touch along a generator of both", rational(0),
             hat(), at(upside_down(hat()), {3, 0, 0})),
      shapes("cones_along_generators_deep", "two cones, one upside down, a quarter deep along a generator of both",
             rational(quarter), hat(), at(upside_down(hat()), {mpq_class(14, 5), 0, mpq_class(-3, 20)})),
      shapes("cones_equal", "the same cone twice: it is 4 high, and 24/5 wide across a generator", rational(4), hat(),
             hat()),
      shapes("cone_in_cone", "a cone in a similar one twice as large, with the same apex and axis", rational(4),
             of_lengths("cone", 6, 4), at(hat(), {0, 0, 2})),
      shapes("cone_in_cylinder", "a cone fills a cylinder of its own height", rational(4), of_lengths("cylinder", 3, 2),
             hat()),
      shapes("frustum_on_frustum", "a frustum stands on the smaller end face of another", rational(0),
             at(of_ends("frustum", 2, 1, 1), {0, 0, 2}), of_ends("frustum", 2, 1, 1)),
      shapes("frustum_on_plane", "a frustum lies on a plane along a generator", rational(0),
             of_ends("frustum", 4, 1, 2), slope(10)),
  };
}

ShapeEntries other_entries() {
  const mpq_class half(1, 2), quarter(1, 4);
  const NamedBody egg = ellipsoid_of(1, 2, 3);
  return {
      shapes("ellipsoid_on_plane", "an ellipsoid stands on a plane by its pole", rational(0), at(egg, {0, 0, 3}),
             ground()),
      shapes("ellipsoid_on_box", "an ellipsoid lies on a box by its flattest point", rational(0), at(egg, {2, 0, 0}),
             block_of(1, 1, 1)),
      shapes("ellipsoids_at_poles", "two ellipsoids touch in poles of different curvature", rational(0), egg,
             at(ellipsoid_of(3, 2, 1), {0, 0, 4})),
      shapes("ellipsoid_in_sphere", "a sphere and an ellipsoid about one centre", rational(4), ball(3), egg),
      shapes("ellipsoid_in_box", "a box and an ellipsoid about one centre", rational(mpq_class(5, 4)),
             block_of(1, 1, 1), ellipsoid_of(quarter, half, mpq_class(3, 4))),
      shapes("tapered_capsule_on_plane", "a hull of two balls lies on a plane along a generator", rational(0),
             of_ends("tapered_capsule", 4, 1, mpq_class(5, 2)), slope(mpq_class(25, 2))),
      shapes("tapered_capsule_on_box", "a hull of two balls stands on a box", rational(0),
             at(of_ends("tapered_capsule", 2, 1, 3), {0, 0, 6}), block_of(1, 1, 1)),
      shapes("margins_touching", "two boxes with margins touch: their cores are a half apart", {half, ratio(-1, 4)},
             rounded(block_of(half, half, half), quarter),
             at(rounded(block_of(half, half, half), quarter), {mpq_class(3, 2), 0, 0})),
      shapes("margins_at_equality", "parallel edges of two boxes are 5 apart, the sum of the margins", {5, -25},
             rounded(block_of(1, 1, 1), 2), at(rounded(block_of(1, 1, 1), 3), {5, 6, half})),
      shapes("margin_of_nothing", "a margin of 0 changes nothing: two boxes share a face", rational(0),
             rounded(block_of(1, 1, 1), 0), at(block_of(1, 1, 1), {2, half, 0})),
      shapes("rounded_cylinder_on_plane", "a cylinder with a margin stands on a plane", rational(0),
             at(rounded(drum(), quarter), {0, 0, 1 + quarter}), ground()),
      shapes("sum_on_plane", "the sum of a cylinder and a cube stands on a plane", rational(0),
             at(named_sum({drum(), block_of(1, 1, 1)}), {0, 0, 2}), ground()),
      shapes("sums_touching", "sums of a cylinder and a cube stand on each other", rational(0),
             named_sum({drum(), block_of(1, 1, 1)}),
             at(named_sum({drum(half), block_of(half, half, half)}), {0, 0, mpq_class(7, 2)})),
  };
}

}  // namespace

std::span<const ShapeCatalogueEntry> shape_catalogue() {
  static const ShapeEntries all = [] {
    ShapeEntries entries;
    for (const auto group : {ball_entries, capsule_entries, cylinder_entries, cone_entries, other_entries})
      std::ranges::move(group(), std::back_inserter(entries));
    return entries;
  }();
  return all;
}

namespace {

using UnionEntries = std::vector<UnionCatalogueEntry>;
constexpr std::optional<bool> none = std::nullopt;
mpq_class slack() { return times_power_of_two(1, -16); }

struct KnownAnswer {
  Status status;
  mpq_class squared;
  std::size_t optima;
  std::optional<bool> clearance;
};
KnownAnswer overlapping(mpq_class squared, std::size_t optima, std::optional<bool> clearance) {
  return {Status::penetrating, std::move(squared), optima, clearance};
}
KnownAnswer touching(bool clearance) { return {Status::touching, 0, 1, clearance}; }
KnownAnswer apart(mpq_class squared) { return {Status::disjoint, std::move(squared), 0, none}; }

UnionCatalogueEntry unions(std::string name, std::string_view description, KnownAnswer answer, Pieces a, Pieces b) {
  const auto body = [](Pieces pieces) {
    return Body{.points = {}, .pieces = std::make_shared<const Pieces>(std::move(pieces))};
  };
  return {description,   answer.status,    std::move(answer.squared),
          answer.optima, answer.clearance, {std::move(name), body(std::move(a)), body(std::move(b))}};
}

/// Between walls whose inner faces are at x = 0 and x = width.
Pieces slot(const mpq_class& width) {
  return {box_from({-9, -5, -5}, {0, 5, 5}), box_from({width, -5, -5}, {width + 9, 5, 5})};
}
/// Of width 1, from x.
Pieces plate(const mpq_class& x) { return {box_from({x, -1, -1}, {x + 1, 1, 1})}; }

/// Six walls about the cube [0,width]^3, 2 thick.
Pieces hollow(const mpq_class& width) {
  const mpq_class end = width + 2;
  return {box_from({-2, -2, -2}, {0, end, end}),   box_from({width, -2, -2}, {end, end, end}),
          box_from({0, -2, -2}, {width, 0, end}),  box_from({0, width, -2}, {width, end, end}),
          box_from({0, 0, -2}, {width, width, 0}), box_from({0, 0, width}, {width, width, end})};
}
Pieces unit_cube() { return {box_from({0, 0, 0}, {1, 1, 1})}; }

/// A square frame about the z axis, in four pieces: the hole is 2 wide, the frame 1 thick.
Pieces frame() {
  return {box_from({-2, -2, 0}, {-1, 2, 1}), box_from({1, -2, 0}, {2, 2, 1}), box_from({-1, -2, 0}, {1, -1, 1}),
          box_from({-1, 1, 0}, {1, 2, 1})};
}
Pieces rod(const mpq_class& half) { return {box_from({-half, -half, -4}, {half, half, 5})}; }

/// A link of a chain along x: a frame with a hole 4 long and 2 wide, in the plane z = 0, or y = 0
/// if upright.
Pieces link(const mpq_class& x, bool upright) {
  const mpq_class half = ratio(1, 2);
  const auto part = [&](const Point& low, const Point& high) {
    return upright ? box_from({x + low.x, low.z, low.y}, {x + high.x, high.z, high.y})
                   : box_from({x + low.x, low.y, low.z}, {x + high.x, high.y, high.z});
  };
  return {part({0, -2, -half}, {6, -1, half}), part({0, 1, -half}, {6, 2, half}), part({0, -1, -half}, {1, 1, half}),
          part({5, -1, -half}, {6, 1, half})};
}

/// An L of two boxes, its corner at O, its arms 3 long along x and y.
Pieces angle() { return {box_from({0, 0, 0}, {3, 1, 1}), box_from({0, 1, 0}, {1, 3, 1})}; }

UnionEntries fits() {
  const mpq_class aside = ratio(3, 4);
  return {
      unions("slot_exact_fit", "a plate beside a slot as wide as itself: the way in is a way out",
             overlapping(ratio(9, 16), 1, false), plate(aside), slot(1)),
      unions("slot_wider", "the slot is wider by 2^-16", overlapping((aside - slack()) * (aside - slack()), 1, true),
             plate(aside), slot(1 + slack())),
      unions("slot_narrower", "the slot is narrower by 2^-16: only the ways past its walls are left",
             overlapping(36, 4, true), plate(aside), slot(1 - slack())),
      unions("slot_filled", "the plate is in the slot, and touches both walls", touching(false), plate(0), slot(1)),
      unions("cavity_filled", "a cube in a cavity of its size: it touches six walls", touching(false), unit_cube(),
             hollow(1)),
      unions("cavity_with_room", "a cube in a cavity that is larger by 2^-16", apart(slack() * slack() / 4),
             translated(unit_cube(), {slack() / 2, slack() / 2, slack() / 2}), hollow(1 + slack())),
      unions("cavity_too_small", "the cavity is smaller by 2^-16: the way out is through the nearest walls",
             overlapping((3 - slack()) * (3 - slack()), 3, true), unit_cube(), hollow(1 - slack())),
      unions("cavity_beside", "a cube in the walls of a cavity of its size: all three ways back into it together",
             overlapping(ratio(3, 4), 1, false), translated(unit_cube(), {ratio(-1, 2), ratio(-1, 2), ratio(-1, 2)}),
             hollow(1)),
  };
}

UnionEntries holds() {
  const mpq_class half = ratio(1, 2);
  const Pieces key = {box_from({-2, ratio(7, 2), half}, {11, ratio(9, 2), ratio(3, 2)}),
                      box_from({ratio(5, 4), ratio(13, 4), half}, {ratio(7, 4), ratio(7, 2), ratio(3, 2)}),
                      box_from({ratio(19, 4), 2, half}, {ratio(21, 4), ratio(7, 2), ratio(3, 2)})};
  const Pieces comb = {box_from({0, 0, 0}, {9, 1, 2}), box_from({0, 1, 0}, {ratio(3, 2), 4, 2}),
                       box_from({ratio(5, 2), 1, 0}, {4, 4, 2}), box_from({5, 1, 0}, {ratio(13, 2), 4, 2}),
                       box_from({ratio(15, 2), 1, 0}, {9, 4, 2})};
  return {
      unions("comb_and_key", "a key whose handle lies in the teeth of a comb, and whose bits stand in the sides of two",
             overlapping(ratio(5, 8), 1, true), key, comb),
      unions("combs_meshed", "two combs, the teeth of each in the gaps of the other: no gap is left", touching(false),
             families::comb(4, 2),
             Pieces{box_from({0, 2, 0}, {7, 3, 1}), box_from({1, 0, 0}, {2, 2, 1}), box_from({3, 0, 0}, {4, 2, 1}),
                    box_from({5, 0, 0}, {6, 2, 1})}),
      unions("combs_tooth_on_tooth", "the same by one tooth: half a tooth to the side is a fit",
             overlapping(ratio(1, 4), 1, false), families::comb(4, 2),
             Pieces{box_from({0, 2, 0}, {8, 3, 1}), box_from({ratio(3, 2), 0, 0}, {ratio(5, 2), 2, 1}),
                    box_from({ratio(7, 2), 0, 0}, {ratio(9, 2), 2, 1})}),
      unions("frame_with_room", "a rod through a frame, with room on all sides", apart(ratio(1, 4)), rod(half),
             frame()),
      unions("frame_filled", "a rod that fills the hole of a frame", touching(false), rod(1), frame()),
      unions("frame_beside", "a rod that fills the hole, moved into two sides of the frame: back into it",
             overlapping(half, 1, false), translated(rod(1), {half, half, 0}), frame()),
      unions("frame_too_small", "a rod wider than the hole by 2^-16: it must pass one side of the frame",
             overlapping(9 + 2 * 3 * slack() / 2 + slack() * slack() / 4, 4, true), rod(1 + slack() / 2), frame()),
      unions("links_with_room", "two links of a chain", apart(ratio(1, 4)), link(0, false), link(3, true)),
      unions("links_taut", "two links of a chain, drawn until they touch", touching(true), link(0, false),
             link(4, true)),
      unions("links_pulled", "two links of a chain, drawn past that", overlapping(ratio(1, 16), 1, true),
             link(0, false), link(ratio(17, 4), true)),
      unions("rings_linked", "two square rings of four wedges, one through the other, with room", apart(ratio(1, 192)),
             ring(4, false), translated(ring(4, true), {ratio(7, 8), 0, 0})),
  };
}

UnionEntries seams() {
  const Pieces grid = cut_into_grid({0, 0, 0}, {3, 3, 3}, 3), whole = {box_from({0, 0, 0}, {3, 3, 3})};
  return {
      unions("cube_in_27_on_itself", "a cube cut into 27, on the same: every seam is on a seam, none is a way out",
             overlapping(9, 6, true), grid, grid),
      unions("cube_in_27_in_the_whole", "a cube cut into 27, on the whole", overlapping(9, 6, true), grid, whole),
      unions("cube_in_27_beside", "two of them side by side", touching(true), grid, translated(grid, {3, 1, 0})),
      unions("cube_repeated", "a cube given three times", overlapping(1, 6, true),
             {unit_cube()[0], unit_cube()[0], unit_cube()[0]}, unit_cube()),
      unions("piece_in_a_piece", "a piece within another counts for nothing", overlapping(9, 6, true),
             {whole[0], box_from({1, 1, 1}, {2, 2, 2})}, whole),
      unions(
          "cone_cuts", "an octahedron, cut into cones, against a cube in slabs", overlapping(ratio(4, 3), 8, true),
          cut_into_cones({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}),
          cut_into_slabs(box_from({ratio(-1, 3), ratio(-1, 3), ratio(-1, 3)}, {ratio(1, 3), ratio(1, 3), ratio(1, 3)}),
                         {1, 1, 1}, 4)),
  };
}

UnionEntries others() {
  const Pieces two = {box_from({0, 0, 0}, {1, 1, 1}), box_from({4, 0, 0}, {5, 1, 1})};
  return {
      unions("angles_end_in_end",
             "two angles, one turned by half a turn: the end of each arm is in an arm of the other",
             overlapping(1, 4, true), angle(), {box_from({0, 2, 0}, {3, 3, 1}), box_from({2, 0, 0}, {3, 2, 1})}),
      unions("angles_nested", "an angle in the corner of another: they touch along both arms", touching(true), angle(),
             translated(angle(), {1, 1, 0})),
      unions("gap_of_a_body", "a cube in the gap between two pieces of the same body", apart(1),
             translated(unit_cube(), {2, 0, 0}), two),
      unions("vertex_on_vertex", "one pair of pieces touches in a vertex", touching(true), two,
             translated(unit_cube(), {5, 1, 1})),
      unions("far_piece", "the deepest pair is no measure: out of one piece is into the next",
             overlapping(ratio(9, 4), 2, true),
             {box_from({ratio(1, 2), ratio(-1, 2), 0}, {ratio(3, 2), ratio(1, 2), 1})},
             {box_from({-3, -1, -4}, {1, 1, 4}), box_from({1, -1, -4}, {5, 1, 4})}),
  };
}

}  // namespace

std::span<const UnionCatalogueEntry> union_catalogue() {
  static const UnionEntries all = [] {
    UnionEntries entries;
    for (const auto group : {fits, holds, seams, others}) std::ranges::move(group(), std::back_inserter(entries));
    return entries;
  }();
  return all;
}

}  // namespace fathom::families
