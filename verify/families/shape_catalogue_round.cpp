// SPDX-License-Identifier: GPL-3.0-or-later
// Balls and capsules: what is exact.
#include "fathom/numbers.hpp"
#include "verify/families/shape_catalogue_groups.hpp"

namespace fathom::families {
namespace {

NamedBody pill(const mpq_class& radius, Axis axis = Axis::z) { return of_lengths("capsule", radius, 1, axis); }

NamedBody flat_triangle() {
  NamedBody body{"triangle"};
  body.fields.vertices = {{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}};
  return body;
}

}  // namespace

ShapeEntries ball_entries() {
  const mpq_class half(1, 2);
  const mpq_class below_root = exact_value(0x1.6a09e667f3bccp-1), above_root = exact_value(0x1.6a09e667f3bcdp-1);  // of 1/2
  return {
      shapes("spheres_concentric", "spheres about one centre: every direction is optimal", rational(3), ball(1), ball(2)),
      shapes("spheres_touching", "two spheres touch", rational(0), ball(1), at(ball(1), {2, 0, 0})),
      shapes("spheres_at_equality", "the sum of the radii, 5, is the distance of the centres", {5, -25}, ball(2), at(ball(3), {3, 4, 0})),
      shapes("spheres_one_ulp_deep", "a radius is one ulp larger than where they touch", {above_two() + 3, -25}, ball(above_two()),
             at(ball(3), {3, 4, 0})),
      shapes("spheres_one_ulp_apart", "a radius is one ulp smaller than where they touch", {below_two() + 3, -25}, ball(below_two()),
             at(ball(3), {3, 4, 0})),
      shapes("spheres_above_a_root", "the distance is the root of 2, and the radii are the doubles just above half of it",
             {2 * above_root, -2}, ball(above_root), at(ball(above_root), {1, 1, 0})),
      shapes("spheres_below_a_root", "the distance is the root of 2, and the radii are the doubles just below half of it",
             {2 * below_root, -2}, ball(below_root), at(ball(below_root), {1, 1, 0})),
      shapes("sphere_on_plane", "a sphere lies on a plane", rational(0), at(ball(1), {0, 0, 1}), ground()),
      shapes("sphere_centre_on_plane", "the centre of a sphere is on a plane", rational(1), ball(1), ground()),
      shapes("sphere_on_box", "a sphere lies on a box", rational(0), at(ball(1), {half, 0, 2}), block_of(1, 1, 1)),
      shapes("sphere_centre_on_face", "the centre of a sphere is on a face", rational(half), at(ball(half), {0, 0, 1}), block_of(1, 1, 1)),
      shapes("sphere_centre_on_edge", "the centre of a sphere is on an edge: a fan of optimal directions", rational(half),
             at(ball(half), {0, 1, 1}), block_of(1, 1, 1)),
      shapes("sphere_centre_on_vertex", "the centre of a sphere is a vertex: an octant of optimal directions", rational(half),
             at(ball(half), {1, 1, 1}), block_of(1, 1, 1)),
      shapes("sphere_centre_in_triangle", "the centre of a sphere is in a triangle, which is flat", rational(half), ball(half),
             flat_triangle()),
      shapes("sphere_under_vertex", "the tip of a pyramid touches a sphere", rational(0), ball(1),
             named_hull({{0, 0, 1}, {2, 2, 3}, {-2, 2, 3}, {-2, -2, 3}, {2, -2, 3}})),
      shapes("ball_that_is_an_ellipsoid", "an ellipsoid with three equal radii against the same sphere", rational(1), ball(1),
             at(ellipsoid_of(1, 1, 1), {1, 0, 0})),
  };
}

ShapeEntries capsule_entries() {
  const mpq_class half(1, 2), quarter(1, 4);
  const NamedBody a = pill(quarter);
  return {
      shapes("capsules_equal", "the same capsule twice: every direction across the axis is optimal", rational(half), a, a),
      shapes("capsules_coaxial", "capsules about one axis, one inside the other", rational(1), a,
             of_lengths("capsule", mpq_class(3, 4), 2)),
      shapes("capsules_end_to_end", "capsules on one axis touch with their ends", rational(0), a, at(a, {0, 0, mpq_class(5, 2)})),
      shapes("capsules_crossing", "the axes cross: the normal of their plane and its opposite are optimal", rational(half), a,
             pill(quarter, Axis::x)),
      shapes("capsules_across", "capsules touch across each other", rational(0), a, at(pill(quarter, Axis::x), {0, half, 0})),
      shapes("capsules_axis_on_end", "an end of one axis is on the other axis", rational(half), a,
             at(pill(quarter, Axis::x), {1, 0, half})),
      shapes("capsules_parallel_touching", "parallel capsules touch along a segment", rational(0), a, at(a, {half, 0, half})),
      shapes("capsules_parallel_deep", "parallel capsules overlap", rational(quarter), a, at(a, {quarter, 0, half})),
      shapes("capsules_at_equality", "the sum of the radii of parallel capsules is the distance of their axes", {5, -25}, pill(2),
             at(pill(3), {3, 4, half})),
      shapes("capsules_one_ulp_deep", "a radius is one ulp larger than where they touch", {above_two() + 3, -25}, pill(above_two()),
             at(pill(3), {3, 4, half})),
      shapes("capsules_one_ulp_apart", "a radius is one ulp smaller than where they touch", {below_two() + 3, -25}, pill(below_two()),
             at(pill(3), {3, 4, half})),
      shapes("sphere_centre_on_segment", "the centre of a sphere is on the axis of a capsule", rational(mpq_class(3, 4)),
             at(ball(half), {0, 0, half}), a),
      shapes("sphere_centre_on_end", "the centre of a sphere is an end of the axis of a capsule", rational(mpq_class(3, 4)),
             at(ball(half), {0, 0, 1}), a),
      shapes("capsule_standing_on_plane", "a capsule stands on a plane", rational(0), at(a, {0, 0, mpq_class(5, 4)}), ground()),
      shapes("capsule_lying_on_plane", "a capsule lies on a plane", rational(0), at(pill(quarter, Axis::y), {0, 0, quarter}), ground()),
      shapes("capsule_lying_on_box", "a capsule lies on a box, and juts out", rational(0), at(pill(quarter, Axis::y), {0, 1, 1 + quarter}),
             block_of(1, 1, 1)),
      shapes("capsule_along_edge", "the axis of a capsule lies in an edge of a box", rational(quarter), at(a, {1, 1, 0}),
             block_of(1, 1, 1)),
  };
}

}  // namespace fathom::families
