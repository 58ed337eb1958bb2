// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies without interior, in all combinations of ranks. P is solid for some of them: then they penetrate, though A has no interior.
#include "verify/families/catalogue_groups.hpp"

namespace fathom::families {

namespace {

constexpr std::string_view solid = "both bodies have an interior", solid_p = "P has an interior";

Known deep(std::size_t optima, std::optional<ContactKind> kind = std::nullopt) { return {Status::penetrating, optima, kind}; }

Body point(const mpq_class& x, const mpq_class& y, const mpq_class& z) { return {{{x, y, z}}}; }

}  // namespace

Entries flat_entries() {
  using enum ContactKind;
  const Body segment{{{0, 0, 0}, {4, 0, 0}}}, upright{{{1, 1, -1}, {1, 1, 2}}};
  const Body square{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}}, wall{{{1, 1, -1}, {1, 4, -1}, {1, 1, 2}}};
  const Body cube = block({0, 0, 0}, {3, 3, 3});
  return {
      entry("flat_point_point", solid_p, "two different points", is_apart, point(0, 0, 0), point(1, 2, 3)),
      entry("flat_point_segment", solid_p, "a point on a segment", touches, point(1, 0, 0), segment),
      entry("flat_point_segment_beyond", solid_p, "a point on a segment's line, beyond its end", is_apart, point(5, 0, 0), segment),
      entry("flat_point_polygon", solid_p, "a point in a square", touches, point(1, 1, 0), square),
      entry("flat_point_solid", solid, "a point in a cube, nearest to one facet", deep(1, vertex_facet), point(1, ratio(3, 2), ratio(3, 2)),
            cube),
      entry("flat_point_solid_corner", solid, "a point at the corner of a cube", touches, point(3, 3, 3), cube),
      entry("flat_segment_point", solid_p, "the end of a segment is the point", touches, segment, point(4, 0, 0)),
      entry("flat_segment_segment", solid_p, "two segments cross: P is a parallelogram around O", touches, segment,
            {{{1, -1, 0}, {1, 2, 0}}}),
      entry("flat_segment_segment_collinear", solid_p, "two segments on one line overlap", touches, segment, {{{3, 0, 0}, {6, 0, 0}}}),
      entry("flat_segment_segment_skew", solid_p, "two skew segments", is_apart, segment, {{{1, -1, 1}, {1, 2, 1}}}),
      entry("flat_segment_polygon", solid, "a segment pierces a square: P is solid", deep(3), upright, square),
      entry("flat_segment_polygon_coplanar", solid_p, "a segment in the plane of a square", touches, segment, square),
      entry("flat_segment_solid", solid, "a segment through a facet of a cube", deep(2, edge_facet), upright, cube),
      entry("flat_polygon_point", solid_p, "a point on the side of a square", touches, square, point(3, 1, 0)),
      entry("flat_polygon_segment", solid, "a square pierced by a segment: P is solid", deep(3), square, upright),
      entry("flat_polygon_polygon", solid, "a square and a triangle cut each other: both flat, P solid", deep(2), square, wall),
      entry("flat_polygon_polygon_coplanar", solid_p, "two squares in one plane overlap: P is flat", touches, square,
            translated(square, {1, 1, 0})),
      entry("flat_polygon_polygon_parallel", solid_p, "two squares in parallel planes", is_apart, square, translated(square, {1, 1, 1})),
      entry("flat_polygon_solid", solid, "a square through a cube", deep(1, facet_facet), translated(square, {1, 1, 1}), cube),
      entry("flat_polygon_solid_facet", solid, "a square that is a facet of the cube", touches, square, cube),
      entry("flat_solid_point", solid, "a cube around a point, two facets nearest", deep(2, facet_vertex), cube, point(ratio(3, 2), 1, 1)),
      entry("flat_solid_segment", solid, "a cube around a segment along an edge direction", deep(4, facet_edge), cube,
            {{{ratio(1, 2), ratio(3, 2), ratio(3, 2)}, {ratio(5, 2), ratio(3, 2), ratio(3, 2)}}}),
      entry("flat_solid_polygon", solid, "a cube cut by a square above its middle", deep(1, facet_facet), cube,
            translated(square, {0, 0, 2})),
  };
}

}  // namespace fathom::families
