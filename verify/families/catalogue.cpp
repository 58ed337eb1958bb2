// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue of degenerate pairs of polytopes, group by group.

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "verify/families/families.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {
namespace {

/// The known part of the answer: its status, the number of optima, and their kind if they have one
/// in common.
struct Known {
  Status status = Status::penetrating;
  std::size_t optima = 0;
  std::optional<ContactKind> kind;
};

constexpr Known touches{Status::touching, 0, std::nullopt}, is_apart{Status::disjoint, 0, std::nullopt};

Known penetrates(std::size_t optima, std::optional<ContactKind> kind = std::nullopt) {
  return {Status::penetrating, optima, kind};
}

CatalogueEntry entry(std::string_view name, std::string_view breaks, std::string_view description, const Known& known,
                     Body a, Body b) {
  return {name,
          breaks,
          description,
          known.status,
          known.optima,
          known.kind,
          {std::string(name), std::move(a), std::move(b)}};
}

/// The corners of the box between two corners, x fastest.
Body block(const Point& low, const Point& high) {
  Body body;
  for (unsigned i = 0; i < 8; ++i)
    body.points.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return body;
}

using Entries = std::vector<CatalogueEntry>;

// ---- meetings ----

// Pairs by how they meet. A stands above the plane z = 0 and B below; a roof over a square base
// ends in a vertex, an edge or a face.

constexpr std::string_view interior = "O is in the interior of P", edges_cross = "no parallel edges",
                           full_normals = "facets are simplices";

/// A's lowest feature, at z = 0 and around O; the edge runs along x. The base is at z = 2.
Body above(FeatureKind feature) {
  Body body;
  if (feature == FeatureKind::vertex) body.points = {{0, 0, 0}};
  if (feature == FeatureKind::edge) body.points = {{-1, 0, 0}, {1, 0, 0}};
  if (feature == FeatureKind::face) body.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  for (const Point& corner : {Point{-2, -2, 2}, Point{2, -2, 2}, Point{2, 2, 2}, Point{-2, 2, 2}})
    body.points.push_back(corner);
  return body;
}

/// B's highest feature, at z = 0 and around O; the edge runs along y. The base is at z = -2.
Body below(FeatureKind feature) { return rotated(above(feature), {Point{0, 1, 0}, Point{1, 0, 0}, Point{0, 0, -1}}); }

Body lowered(const Body& body, const mpq_class& by) { return translated(body, {0, 0, mpq_class(-by)}); }

CatalogueEntry touching_entry(std::string_view name, std::string_view description, FeatureKind a, FeatureKind b) {
  return entry(name, interior, description, touches, above(a), below(b));
}

CatalogueEntry contact_entry(std::string_view name, std::string_view description, ContactKind kind, FeatureKind a,
                             FeatureKind b) {
  return entry(name, kind == ContactKind::edge_edge ? "no shared facet normals" : full_normals, description,
               {Status::penetrating, 1, kind}, lowered(above(a), ratio(1, 4)), below(b));
}

Entries touching_entries() {
  using enum FeatureKind;
  return {
      touching_entry("touching_vertex_vertex", "the tips of two pyramids touch in exactly one point", vertex, vertex),
      touching_entry("touching_vertex_edge", "the tip of a pyramid touches the ridge of a roof in exactly one point",
                     vertex, edge),
      touching_entry("touching_vertex_face", "the tip of a pyramid touches a face in exactly one point", vertex, face),
      touching_entry("touching_edge_vertex", "the ridge of a roof touches the tip of a pyramid in exactly one point",
                     edge, vertex),
      touching_entry("touching_edge_edge", "two ridges cross in exactly one point", edge, edge),
      touching_entry("touching_edge_face", "the ridge of a roof lies in a face", edge, face),
      touching_entry("touching_face_vertex", "a face touches the tip of a pyramid in exactly one point", face, vertex),
      touching_entry("touching_face_edge", "the ridge of a roof lies in a face of A", face, edge),
      touching_entry("touching_face_face", "two faces lie in one plane and overlap", face, face),
      entry("touching_parallel_edges", edges_cross, "two ridges overlap in a segment", touches, above(edge),
            translated(scaled(above(edge), 1, 1, -1), {1, 0, 0})),
      entry("touching_cubes_corner", interior, "two cubes of a grid share exactly one point, a corner of both", touches,
            block({0, 0, 0}, {1, 1, 1}), block({1, 1, 1}, {2, 2, 2})),
      entry("touching_cubes_edge", interior, "two cubes of a grid share an edge", touches, block({0, 0, 0}, {1, 1, 1}),
            block({1, 1, 0}, {2, 2, 1})),
      entry("touching_cubes_facet", interior, "two cubes of a grid share a facet", touches, block({0, 0, 0}, {1, 1, 1}),
            block({1, 0, 0}, {2, 1, 1})),
  };
}

Entries contact_entries() {
  using enum FeatureKind;
  using enum ContactKind;
  const Body roof = lowered(above(edge), ratio(1, 4));
  return {
      contact_entry("contact_facet_vertex", "a face is a quarter deep in the tip of a pyramid", facet_vertex, face,
                    vertex),
      contact_entry("contact_vertex_facet", "the tip of a pyramid is a quarter deep in a face", vertex_facet, vertex,
                    face),
      contact_entry("contact_facet_edge", "a face is a quarter deep in the ridge of a roof", facet_edge, face, edge),
      contact_entry("contact_edge_facet", "the ridge of a roof is a quarter deep in a face", edge_facet, edge, face),
      contact_entry("contact_facet_facet", "a face is a quarter deep in a face", facet_facet, face, face),
      contact_entry("contact_edge_edge", "two crossing ridges are a quarter deep in each other", edge_edge, edge, edge),
      entry(
          "contact_parallel_edges", edges_cross,
          "two parallel ridges are a quarter deep in each other: no facet of P is theirs, the nearest are of the roofs",
          {Status::penetrating, 2, facet_facet}, roof, scaled(above(edge), 1, 1, -1)),
      entry("contact_cubes", full_normals, "two unit cubes of a grid, a third deep: four pairs of coplanar facets",
            {Status::penetrating, 1, facet_facet}, block({0, 0, 0}, {1, 1, 1}),
            block({ratio(2, 3), 0, 0}, {ratio(5, 3), 1, 1})),
  };
}

// ---- flat bodies ----

// Bodies without interior, in all combinations of ranks. P is solid for some of them: then they
// penetrate, though A has no interior.

constexpr std::string_view solid = "both bodies have an interior", solid_p = "P has an interior";

Body point(const mpq_class& x, const mpq_class& y, const mpq_class& z) { return {{{x, y, z}}}; }

Entries flat_entries() {
  using enum ContactKind;
  const Body segment{{{0, 0, 0}, {4, 0, 0}}}, upright{{{1, 1, -1}, {1, 1, 2}}};
  const Body square{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}}, wall{{{1, 1, -1}, {1, 4, -1}, {1, 1, 2}}};
  const Body cube = block({0, 0, 0}, {3, 3, 3});
  return {
      entry("flat_point_point", solid_p, "two different points", is_apart, point(0, 0, 0), point(1, 2, 3)),
      entry("flat_point_segment", solid_p, "a point on a segment", touches, point(1, 0, 0), segment),
      entry("flat_point_segment_beyond", solid_p, "a point on a segment's line, beyond its end", is_apart,
            point(5, 0, 0), segment),
      entry("flat_point_polygon", solid_p, "a point in a square", touches, point(1, 1, 0), square),
      entry("flat_point_solid", solid, "a point in a cube, nearest to one facet", penetrates(1, vertex_facet),
            point(1, ratio(3, 2), ratio(3, 2)), cube),
      entry("flat_point_solid_corner", solid, "a point at the corner of a cube", touches, point(3, 3, 3), cube),
      entry("flat_segment_point", solid_p, "the end of a segment is the point", touches, segment, point(4, 0, 0)),
      entry("flat_segment_segment", solid_p, "two segments cross: P is a parallelogram around O", touches, segment,
            {{{1, -1, 0}, {1, 2, 0}}}),
      entry("flat_segment_segment_collinear", solid_p, "two segments on one line overlap", touches, segment,
            {{{3, 0, 0}, {6, 0, 0}}}),
      entry("flat_segment_segment_skew", solid_p, "two skew segments", is_apart, segment, {{{1, -1, 1}, {1, 2, 1}}}),
      entry("flat_segment_polygon", solid, "a segment pierces a square: P is solid", penetrates(3), upright, square),
      entry("flat_segment_polygon_coplanar", solid_p, "a segment in the plane of a square", touches, segment, square),
      entry("flat_segment_solid", solid, "a segment through a facet of a cube", penetrates(2, edge_facet), upright,
            cube),
      entry("flat_polygon_point", solid_p, "a point on the side of a square", touches, square, point(3, 1, 0)),
      entry("flat_polygon_segment", solid, "a square pierced by a segment: P is solid", penetrates(3), square, upright),
      entry("flat_polygon_polygon", solid, "a square and a triangle cut each other: both flat, P solid", penetrates(2),
            square, wall),
      entry("flat_polygon_polygon_coplanar", solid_p, "two squares in one plane overlap: P is flat", touches, square,
            translated(square, {1, 1, 0})),
      entry("flat_polygon_polygon_parallel", solid_p, "two squares in parallel planes", is_apart, square,
            translated(square, {1, 1, 1})),
      entry("flat_polygon_solid", solid, "a square through a cube", penetrates(1, facet_facet),
            translated(square, {1, 1, 1}), cube),
      entry("flat_polygon_solid_facet", solid, "a square that is a facet of the cube", touches, square, cube),
      entry("flat_solid_point", solid, "a cube around a point, two facets nearest", penetrates(2, facet_vertex), cube,
            point(ratio(3, 2), 1, 1)),
      entry("flat_solid_segment", solid, "a cube around a segment along an edge direction", penetrates(4, facet_edge),
            cube, {{{ratio(1, 2), ratio(3, 2), ratio(3, 2)}, {ratio(5, 2), ratio(3, 2), ratio(3, 2)}}}),
      entry("flat_solid_polygon", solid, "a cube cut by a square above its middle", penetrates(1, facet_facet), cube,
            translated(square, {0, 0, 2})),
  };
}

// ---- input points, and near degeneracies ----

// Pairs whose input points are degenerate before any geometry begins, and pairs that are degenerate
// except for 2^-1000.

constexpr std::string_view extreme = "all points are extreme";

Body with(Body body, const std::vector<Point>& more) {
  std::vector<Point>& points = body.points.edit();
  points.insert(points.end(), more.begin(), more.end());
  return body;
}

mpq_class tiny() { return times_power_of_two(1, -1000); }

Entries redundant_entries() {
  using enum ContactKind;
  const Body two = block({0, 0, 0}, {2, 2, 2}), other = block({1, ratio(1, 2), ratio(1, 3)}, {3, 3, 3});
  const Known third = penetrates(1, facet_facet);
  return {
      entry("duplicate_points", "points are distinct", "a cube with every corner given twice", third,
            with(two, two.points), other),
      entry("duplicate_points_both", "points are distinct", "two tetrahedra with repeated corners, the first ones last",
            penetrates(1, edge_edge), {{{0, 0, 3}, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {0, 0, 0}}},
            {{{2, 2, 3}, {1, 1, 1}, {-2, 1, 1}, {1, -3, 1}, {1, 1, 1}}}),
      entry("collinear_points", extreme, "a cube with points on its edges", third,
            with(two, {{1, 0, 0}, {0, 1, 0}, {2, 2, 1}, {0, ratio(1, 2), 0}}), other),
      entry("coplanar_points", extreme, "a cube with points in its facets", third,
            with(two, {{1, 1, 0}, {ratio(1, 2), 1, 0}, {0, 1, 1}, {1, 2, 1}}), other),
      entry("interior_points", extreme, "a cube with points in its interior, given first", third,
            with({{{1, 1, 1}, {ratio(1, 2), 1, 1}, {1, 1, 1}}}, two.points), other),
  };
}

Entries near_entries() {
  using enum ContactKind;
  const Body unit = block({0, 0, 0}, {1, 1, 1});
  const Body tip{{{0, 0, 0}, {-2, -2, 2}, {2, -2, 2}, {2, 2, 2}, {-2, 2, 2}}}, tip_below = scaled(tip, -1);
  const mpq_class above_one = 1 + tiny(), below_one = 1 - tiny();
  return {
      entry("nearly_touching_apart", "the bodies are clearly apart", "two cubes with a gap of 2^-1000", is_apart, unit,
            block({above_one, 0, 0}, {2, 1, 1})),
      entry("nearly_touching_deep", "the bodies overlap clearly", "two cubes 2^-1000 deep", penetrates(1, facet_facet),
            unit, block({below_one, 0, 0}, {2, 1, 1})),
      entry("nearly_touching_tips_apart", "the bodies are clearly apart",
            "the tips of two pyramids with a gap of 2^-1000", is_apart, tip,
            translated(tip_below, {0, 0, mpq_class(-tiny())})),
      entry("nearly_touching_tips_deep", "the bodies overlap clearly", "the tips of two pyramids, 2^-1000 deep",
            penetrates(4, facet_facet), tip, translated(tip_below, {0, 0, tiny()})),
      entry("nearly_tied", "ties are exact or clearly broken",
            "a cube in a cube, off its centre by 2^-1000 along one axis", penetrates(1, facet_facet), cube(),
            translated(box(2, 2, 2), {tiny(), 0, 0})),
      entry("nearly_identical", "the bodies share features or not",
            "a tetrahedron against itself with one corner moved by 2^-1000", penetrates(5, edge_edge), tetrahedron(),
            {{{above_one, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}}),
      entry("nearly_parallel_edges", "edges are parallel or not", "a prism along z and one whose axis leans by 2^-1000",
            penetrates(1, edge_edge), {{{0, 0, -2}, {4, 1, -2}, {1, 4, -2}, {0, 0, 2}, {4, 1, 2}, {1, 4, 2}}},
            {{{2, 3, -3},
              {3, -2, -3},
              {-2, 1, -3},
              {mpq_class(2 + tiny()), 3, 3},
              {mpq_class(3 + tiny()), -2, 3},
              {mpq_class(-2 + tiny()), 1, 3}}}),
      entry("nearly_flat", "bodies are flat or not", "a tetrahedron 2^-1000 thick in a cube",
            penetrates(1, vertex_facet), {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {ratio(1, 3), ratio(1, 3), tiny()}}},
            block({-1, -2, ratio(-1, 4)}, {3, 3, 2})),
  };
}

// ---- shared features ----

// Pairs with features in common: identical and mirrored bodies, parallel edges, common normals,
// prisms on one axis, ties by the dozen.

constexpr std::string_view distinct = "the bodies share no features", one_nearest = "one nearest facet";

CatalogueEntry identical_entry(std::string_view name, std::string_view description, const Known& known,
                               const Body& body) {
  return entry(name, distinct, description, known, body, body);
}

/// All integer points of {0..side}^3, x fastest.
Body grid(int side) {
  Body body;
  for (int z = 0; z <= side; ++z)
    for (int y = 0; y <= side; ++y)
      for (int x = 0; x <= side; ++x) body.points.push_back({x, y, z});
  return body;
}

/// The permutations of (0, +-1, +-2): six squares and eight hexagons.
Body truncated_octahedron() {
  Body body;
  for (const int one : {-1, 1})
    for (const int two : {-2, 2})
      for (const Point& p : {Point{0, one, two}, Point{0, two, one}, Point{one, 0, two}, Point{two, 0, one},
                             Point{one, two, 0}, Point{two, one, 0}})
        body.points.push_back(p);
  return body;
}

/// The prism along z over a polygon.
Body prism_over(const std::vector<std::array<int, 2>>& polygon, int low, int high) {
  Body body;
  for (const int z : {low, high})
    for (const auto& [x, y] : polygon) body.points.push_back({x, y, z});
  return body;
}

Entries shared_entries() {
  using enum ContactKind;
  const Body unit = block({0, 0, 0}, {1, 1, 1}), two = block({0, 0, 0}, {2, 2, 2});
  const Body square = prism_over({{2, 2}, {-2, 2}, {-2, -2}, {2, -2}}, -3, 3),
             diamond = prism_over({{3, 0}, {0, 3}, {-3, 0}, {0, -3}}, -2, 4);
  const Body triangle = prism_over({{3, 0}, {-2, 2}, {-2, -2}}, -3, 3);
  return {
      identical_entry("identical_cubes", "{0,1}^3 against itself: its width, in six directions",
                      penetrates(6, facet_facet), unit),
      identical_entry("identical_tetrahedra", "a regular tetrahedron against itself: its width, between opposite edges",
                      penetrates(6, edge_edge), tetrahedron()),
      identical_entry("identical_octahedra", "an octahedron against itself: its width, between opposite facets",
                      penetrates(8, facet_facet), octahedron()),
      identical_entry("identical_points", "a point against itself", touches, {{{1, 2, 3}}}),
      identical_entry("identical_segments", "a segment against itself", touches, {{{0, 0, 0}, {1, 2, 3}}}),
      identical_entry("identical_polygons", "a square against itself", touches,
                      {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}}),
      entry("mirrored_tetrahedra", distinct, "B = -A: all nodes and arcs of the two Gaussian diagrams coincide",
            penetrates(4, facet_facet), tetrahedron(), scaled(tetrahedron(), -1)),
      entry("nested_cubes", one_nearest, "a cube in the centre of a larger one: six nearest facets",
            penetrates(6, facet_facet), cube(), box(2, 2, 2)),
      entry("nested_cubes_corner", distinct,
            "a cube in the corner of a larger one: three pairs of coplanar facets, one common vertex",
            penetrates(3, facet_facet), unit, two),
      entry("lattice_grids", one_nearest,
            "{0..3}^3, all 64 points, against itself moved by (2, 2, 2): three nearest facets",
            penetrates(3, facet_facet), grid(3), translated(grid(3), {2, 2, 2})),
      entry("lattice_grids_two", one_nearest, "{0..2}^3, all 27 points, against itself moved by (1, 1, 0)",
            penetrates(2, facet_facet), grid(2), translated(grid(2), {1, 1, 0})),
      identical_entry("lattice_truncated_octahedra",
                      "a lattice polytope against itself: ties between opposite hexagons", penetrates(8, facet_facet),
                      truncated_octahedron()),
      entry("parallel_edges", edges_cross, "two triangular prisms with parallel axes, no other feature in common",
            penetrates(1, facet_edge), prism_over({{3, 0}, {-2, 3}, {-2, -1}}, -3, 3),
            translated(prism_over({{-3, 0}, {1, 4}, {3, -2}}, -2, 5), {2, 1, 0})),
      entry("parallel_edges_cubes", edges_cross,
            "cubes of different sizes along the axes: edges of all three directions are parallel",
            penetrates(1, facet_facet), unit, block({ratio(1, 2), ratio(1, 3), ratio(1, 4)}, {2, 3, 4})),
      entry("prisms_on_common_axis", distinct, "a square prism and a diamond prism around the same axis",
            penetrates(4, edge_facet), square, diamond),
      entry("prisms_on_common_axis_identical", distinct, "a triangular prism against itself", penetrates(4), triangle,
            triangle),
      entry("common_facet_normals", "no shared facet normals",
            "pyramids upright over parallel bases: the bases face the same way", penetrates(2),
            {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 5}}}, {{{0, 0, 1}, {3, 1, 1}, {1, 3, 1}, {2, 1, 4}}}),
      entry("opposite_facet_normals", "no shared facet normals",
            "two pyramids with their bases towards each other, a unit deep", penetrates(1, facet_facet),
            {{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {2, 2, 5}}}, {{{1, 0, 1}, {6, 1, 1}, {1, 6, 1}, {2, 1, -5}}}),
      entry("coplanar_facets", "no coplanar facets",
            "two pyramids with their bases in one plane, on the same side of it", penetrates(1, edge_edge),
            {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 5}}}, {{{1, 1, 0}, {5, 2, 0}, {2, 5, 0}, {2, 3, 4}}}),
  };
}

// ---- the sphere of directions ----

// Pairs that are degenerate for the charts alone: the decomposition looks at directions from the
// pole z = (0, 0, 1), splits the sphere at the equator z = 0, and sweeps along the vertical v = (0,
// 1, 0). Turned by any other rotation they are harmless.

constexpr std::string_view off_equator = "no direction on the equator", one_each = "at most one node on a vertical",
                           off_arcs = "no normal of one body on an arc of the other",
                           off_poles = "no normal at a pole of the chart";

/// Twelve rhombs with the normals (+-1, +-1, 0) and permutations.
Body rhombic_dodecahedron() {
  Body body = cube();
  for (const Point& corner : scaled(octahedron(), 2).points) body.points.push_back(corner);
  return body;
}

/// No two edges parallel, no coordinate of an edge or a normal zero.
Body generic_tetrahedron() { return {{{3, 1, 2}, {-2, 4, 1}, {-1, -3, 3}, {1, 2, -4}}}; }

Entries sphere_entries() {
  using enum ContactKind;
  return {
      entry("normals_at_the_poles", off_poles, "two pyramids with horizontal bases, one facing up and one down",
            penetrates(1, facet_facet), {{{3, 1, -1}, {-2, 4, -1}, {-1, -3, -1}, {1, 1, 4}}},
            {{{2, 3, 2}, {-4, 1, 2}, {1, -3, 2}, {1, 2, -3}}}),
      entry("normals_at_the_vertical", "no normal at the vertical",
            "the bases of two pyramids have the normals (0, -1, 0) and (0, 1, 0)", penetrates(1, facet_facet),
            {{{3, -1, 1}, {-2, -1, 4}, {-1, -1, -3}, {1, 4, 1}}}, {{{2, 2, 3}, {-4, 2, 1}, {1, 2, -3}, {1, -3, 2}}}),
      entry("normals_on_the_equator", off_equator, "each body has a facet whose normal has z = 0, and no vertical edge",
            penetrates(1, edge_edge), {{{0, 0, 0}, {0, 2, 1}, {0, 1, 3}, {3, 1, 1}}},
            {{{2, 0, 1}, {0, 2, 0}, {1, 1, 3}, {-1, -2, 2}}}),
      entry("arcs_on_the_equator", off_equator, "each body has one vertical edge: its arc lies on the equator",
            penetrates(1, edge_facet), {{{0, 0, -2}, {0, 0, 2}, {4, 3, 1}, {3, -4, -1}}},
            {{{2, 0, -3}, {2, 0, 3}, {-2, 1, 2}, {-1, -3, 1}}}),
      entry("arcs_through_the_vertical", one_each,
            "each body has an edge with y = 0 in its direction: its arc stands upright in the chart",
            penetrates(1, vertex_facet), {{{0, 1, 0}, {3, 1, 2}, {1, -2, 4}, {2, 4, 3}}},
            {{{1, 0, 1}, {4, 0, -1}, {2, 3, 2}, {2, -1, 4}}}),
      entry("nodes_on_one_vertical", one_each,
            "B has the normal (1, -1, 3) and -A the normal (1, 2, 3): the same x in the chart",
            penetrates(1, vertex_facet), {{{1, 1, -1}, {-2, 1, 0}, {3, 0, -1}, {1, 1, 3}}},
            {{{1, 1, 0}, {0, 3, 1}, {3, 0, -1}, {0, 0, -4}}}),
      entry("nodes_all_on_one_vertical", one_each, "a prism along x: its ring of normals stands on one vertical",
            penetrates(1, vertex_facet), {{{0, 0, 1}, {0, 1, -1}, {0, -1, -2}, {3, 0, 1}, {3, 1, -1}, {3, -1, -2}}},
            generic_tetrahedron()),
      entry("normals_on_arcs", off_arcs,
            "a cube against a rhombic dodecahedron: its normals lie in the middle of the cube's arcs",
            penetrates(12, facet_edge), rhombic_dodecahedron(), cube()),
      entry("arcs_bisect_arcs", "no crossing at a symmetric place",
            "a cube against an octahedron: their arcs bisect each other", penetrates(6, facet_vertex), cube(),
            octahedron()),
      entry("crossings_on_the_equator", off_equator,
            "an octahedron's edge along (1, -1, 0) and one along (1, -1, 1) meet at (1, 1, 0)",
            penetrates(1, facet_vertex), {{{-2, 0, -1}, {-1, -1, 0}, {2, 1, 1}, {1, 2, -2}, {1, 1, 2}}},
            scaled(octahedron(), 2)),
      entry("poles_of_both", off_poles, "antiprisms on one axis: normals at both poles, all else in general position",
            penetrates(2, facet_facet), antiprism(3, 1), scaled(antiprism(5, 1), 1, 1, ratio(1, 2))),
      entry("great_circle_of_arcs", "no arcs on one great circle",
            "a prism whose edges give arcs all around one tilted great circle", penetrates(1, facet_vertex),
            {{{0, 0, 0}, {3, 1, 0}, {1, 3, 0}, {1, 1, 4}, {4, 2, 4}, {2, 4, 4}}},
            translated(generic_tetrahedron(), {1, 1, 1})),
  };
}

}  // namespace

std::span<const CatalogueEntry> catalogue() {
  static const Entries all = [] {
    Entries entries;
    for (const auto group : {touching_entries, contact_entries, shared_entries, sphere_entries, redundant_entries,
                             flat_entries, near_entries})
      std::ranges::move(group(), std::back_inserter(entries));
    return entries;
  }();
  return all;
}

const CatalogueEntry* find_catalogue_entry(std::string_view name) {
  const std::span<const CatalogueEntry> all = catalogue();
  const auto found = std::ranges::find(all, name, &CatalogueEntry::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace fathom::families
