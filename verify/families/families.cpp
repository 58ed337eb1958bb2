// SPDX-License-Identifier: GPL-3.0-or-later
// The table of families: one row, one sentence, one generator each.

#include "verify/families/families.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "reference/files/piece_files.hpp"
#include "verify/families/plane_pairs.hpp"
#include "verify/families/polytope_pairs.hpp"
#include "verify/families/shape_pairs.hpp"

namespace fathom::families {
namespace {

template <FeatureKind A, FeatureKind B>
Bodies touching(Random& random, unsigned n) {
  return touching(A, B, random, n);
}

template <FeatureKind A, FeatureKind B>
Bodies overlapping(Random& random, unsigned n) {
  return overlapping(A, B, random, n);
}

template <long Nanoradians>
Bodies faces(Random& random, unsigned n) {
  return faces(ratio(Nanoradians, 1'000'000'000), random, n);
}

template <int RankA, int RankB>
Bodies flat(Random& random, unsigned n) {
  return flat(RankA, RankB, random, n);
}

template <Degradation Way>
Bodies degraded(Random& random, unsigned n) {
  return degraded(Way, random, n);
}

template <FeatureKind A, FeatureKind B>
Bodies inverse(Random& random, unsigned n) {
  return inverse(A, B, random, n);
}

template <const FloatFormat& Format>
Bodies rounding(Random& random, unsigned n) {
  return rounding_boundary(Format, random, n);
}

template <ShapeKind A, ShapeKind B>
NamedPair pair(Random& random, unsigned n) {
  return random_pair(A, B, random, n);
}

NamedPair with_plane(Random& random, unsigned n) {
  const ShapeKind kind = random_kind(random);
  return random_pair_with_plane(kind, random, n);
}

template <NamedPair (*Pair)(ShapeKind, ShapeKind, Random&, unsigned)>
NamedPair of_any_kinds(Random& random, unsigned n) {
  const ShapeKind a = random_kind(random), b = random_kind(random);
  return Pair(a, b, random, n);
}

template <MakeMeetingBody First, MakeMeetingBody Second>
NamedPair of_contacts(Random& random, unsigned /*n*/) {
  return meeting(First, Second, random);
}

constexpr unsigned corners = 8;

constexpr Family table[] = {
    // ==== polytopes ====
    // Random bodies.
    {"random_ball", "points in a ball; B shifted by up to 1 along each axis", 20, random_ball},
    {"random_sphere", "points near a sphere, all extreme; B shifted by up to 1 along each axis", 20, random_sphere},
    {"random_lattice", "points of {0..3}^3: duplicates, collinear and coplanar points", 10, random_lattice},
    {"random_disjoint", "balls of points, well apart", 20, random_disjoint},
    {"boxes_posed", "boxes in rational poses; the size is ignored", 8, boxes_posed},
    {"boxes_aligned", "boxes with corners in {0..4}^3: coplanar facets, parallel edges; the size is ignored", 8,
     boxes_aligned},
    {"platonic_posed", "platonic solids in rational poses; the size is ignored", 20, platonic_posed},
    {"platonic_aligned", "platonic solids, shifted but not turned; the size is ignored", 20, platonic_aligned},
    {"prisms_posed", "prisms and antiprisms in rational poses", 20, prisms_posed},
    {"needles", "two needles, a million times longer than wide", 20, needles},
    {"plates", "two plates, a million times wider than thick", 20, plates},
    {"needle_and_plate", "a needle against a plate", 20, needle_and_plate},
    // Crossed bundles.
    {"crossed_fans", "crossed fans on circles: K = Theta(n^2), one clear optimum", 50, crossed_fans},
    {"crossed_parabolas",
     "crossed fans on a paraboloid: the minimum runs along a circle, with exact ties; the seed is ignored", 50,
     crossed_parabolas},
    {"crossed_random_parabolas", "crossed fans on a paraboloid at random places: near ties along a circle", 50,
     crossed_random_parabolas},
    {"crossed_twists",
     "crossed fans over twisted cubics: no three edges of a bundle across one axis, and two regions compete", 50,
     crossed_twists},
    {"crossed_patch", "crossed fans over a small patch of a sphere: n^2 near ties; the seed is ignored", 50,
     crossed_patch},
    {"crossed_prisms", "the rims of two prisms across each other", 50, crossed_prisms},
    {"crossed_random_prisms", "the rims of two prisms across each other, with corners and heights at random", 50,
     crossed_random_prisms},
    {"crossed_bands", "thin bands around two circles across each other", 50, crossed_bands},
    {"crossed_ties", "crossed fans over a fixed patch: n^2 distances that agree to 1.2e-7", 50, crossed_ties},
    {"crossed_shrinking_ties", "crossed fans over a patch of width n^-1/2: n^2 distances that agree to 1/(32 n^2)", 50,
     crossed_shrinking_ties},
    {"crossed_vanishing_ties", "crossed fans over a patch of width 1/n: n^2 distances that agree to about 1/(8 n^4)",
     50, crossed_vanishing_ties},
    {"crossed_noisy_ties",
     "the same with corners rounded to multiples of 2^-k, k between 50 and 90: noise on near ties", 50,
     crossed_noisy_ties},
    {"crossed_fillets",
     "bent bars with rounded edges across each other: two regions compete, and tie within about 2^-16", 50,
     crossed_fillets},
    // Ties.
    {"exact_ties", "a symmetric solid against itself: many optima", 12, exact_ties},
    {"near_ties", "a symmetric solid against itself, moved by about 2^-k: optima that nearly tie", 12, near_ties},
    {"near_tie_boxes", "boxes with depths 1, 1 + 2^-k, 1 + 2^-j along three axes; the size is ignored", 8,
     near_tie_boxes},
    // Shared features.
    {"identical", "a random body against itself: its width", 20, identical},
    {"mirrored", "B = -A: the Gaussian diagrams of B and -A coincide", 20, mirrored},
    {"nested", "B is a smaller copy of A inside A, or nearly", 20, nested},
    {"common_normals", "B is a scaled copy of A or of -A", 20, common_normals},
    {"parallel_edges", "prisms with parallel axes", 16, parallel_edges},
    {"redundant_points", "lattice bodies with repeated, interior and boundary points", 8, redundant_points},
    // Coordinates.
    {"tiny_coordinates", "spheres of radius 1e-300", 12, tiny_coordinates},
    {"huge_coordinates", "spheres of radius 1e300", 12, huge_coordinates},
    {"uneven_coordinates", "spheres stretched to 1e300, 1 and 1e-300", 12, uneven_coordinates},
    {"wild_coordinates", "every coordinate with its own exponent between 1e-300 and 1e300", 12, wild_coordinates},
    {"far_boxes", "boxes in rational poses, 10^3 to 9 10^6 away from the origin along each axis; the size is ignored",
     8, far_boxes},
    {"far_sphere", "points near a sphere, all extreme, 10^3 to 9 10^6 away from the origin along each axis", 20,
     far_sphere},
    // Touching, by the features of A and of B that meet.
    {"touching_vertex_vertex", "a vertex of A touches a vertex of B", 6,
     touching<FeatureKind::vertex, FeatureKind::vertex>},
    {"touching_vertex_edge", "a vertex of A touches an edge of B", 6, touching<FeatureKind::vertex, FeatureKind::edge>},
    {"touching_vertex_face", "a vertex of A touches a face of B", 6, touching<FeatureKind::vertex, FeatureKind::face>},
    {"touching_edge_vertex", "an edge of A touches a vertex of B", 6, touching<FeatureKind::edge, FeatureKind::vertex>},
    {"touching_edge_edge", "an edge of A touches an edge of B, crossing", 6,
     touching<FeatureKind::edge, FeatureKind::edge>},
    {"touching_edge_face", "an edge of A touches a face of B", 6, touching<FeatureKind::edge, FeatureKind::face>},
    {"touching_face_vertex", "a face of A touches a vertex of B", 6, touching<FeatureKind::face, FeatureKind::vertex>},
    {"touching_face_edge", "a face of A touches an edge of B", 6, touching<FeatureKind::face, FeatureKind::edge>},
    {"touching_face_face", "a face of A touches a face of B", 6, touching<FeatureKind::face, FeatureKind::face>},
    {"touching_parallel_edges", "an edge of A touches a parallel edge of B", 6, touching_parallel_edges},
    {"nearly_touching", "any of the nine, apart or overlapping by 2^-k", 6, nearly_touching},
    // Penetrating by 2^-k, by the kind of contact.
    {"contact_facet_vertex", "one optimum, of kind facet-vertex, depth 2^-k", 6,
     overlapping<FeatureKind::face, FeatureKind::vertex>},
    {"contact_vertex_facet", "one optimum, of kind vertex-facet, depth 2^-k", 6,
     overlapping<FeatureKind::vertex, FeatureKind::face>},
    {"contact_facet_edge", "one optimum, of kind facet-edge, depth 2^-k", 6,
     overlapping<FeatureKind::face, FeatureKind::edge>},
    {"contact_edge_facet", "one optimum, of kind edge-facet, depth 2^-k", 6,
     overlapping<FeatureKind::edge, FeatureKind::face>},
    {"contact_facet_facet", "one optimum, of kind facet-facet, depth 2^-k", 6,
     overlapping<FeatureKind::face, FeatureKind::face>},
    {"contact_edge_edge", "one optimum, of kind edge-edge, depth 2^-k", 6,
     overlapping<FeatureKind::edge, FeatureKind::edge>},
    // A face of A in a face of B, in doubles, by the angle between them.
    {"faces_parallel", "part of a face of A in a face of B, in doubles: exactly parallel", 8, faces<0>},
    {"faces_tilted_hair", "the same, A turned by 1e-9 about a line in its face", 8, faces<1>},
    {"faces_tilted_slightly", "the same, A turned by 1e-4", 8, faces<100'000>},
    {"faces_tilted", "the same, A turned by 0.01", 8, faces<10'000'000>},
    // Bodies without interior.
    {"point_point", "a point against a point, small half-integers", 6, flat<0, 0>},
    {"point_segment", "a point against a segment, small half-integers", 6, flat<0, 1>},
    {"point_polygon", "a point against a polygon, small half-integers", 6, flat<0, 2>},
    {"point_solid", "a point against a solid, small half-integers", 6, flat<0, 3>},
    {"segment_point", "a segment against a point, small half-integers", 6, flat<1, 0>},
    {"segment_segment", "a segment against a segment, small half-integers", 6, flat<1, 1>},
    {"segment_polygon", "a segment against a polygon, small half-integers", 6, flat<1, 2>},
    {"segment_solid", "a segment against a solid, small half-integers", 6, flat<1, 3>},
    {"polygon_point", "a polygon against a point, small half-integers", 6, flat<2, 0>},
    {"polygon_segment", "a polygon against a segment, small half-integers", 6, flat<2, 1>},
    {"polygon_polygon", "a polygon against a polygon, small half-integers", 6, flat<2, 2>},
    {"polygon_solid", "a polygon against a solid, small half-integers", 6, flat<2, 3>},
    {"solid_point", "a solid against a point, small half-integers", 6, flat<3, 0>},
    {"solid_segment", "a solid against a segment, small half-integers", 6, flat<3, 1>},
    {"solid_polygon", "a solid against a polygon, small half-integers", 6, flat<3, 2>},
    // Broken on purpose.
    {"catalogue", "entries of the catalogue of degenerate pairs, in random order; the size is ignored", 10,
     from_catalogue},
    {"approaching", "entries of the catalogue, every point moved by about 2^-k; the size is ignored", 10,
     approaching_catalogue},
    {"degraded_duplicate_points", "spheres of points; some points are given again", 10,
     degraded<Degradation::duplicate_points>},
    {"degraded_collinear_points", "spheres of points; points inside edges", 10,
     degraded<Degradation::collinear_points>},
    {"degraded_coplanar_points", "spheres of points; a facet with four corners or more, and a point inside it", 10,
     degraded<Degradation::coplanar_points>},
    {"degraded_shared_vertex", "spheres of points; a vertex of A is a vertex of B", 10,
     degraded<Degradation::shared_vertex>},
    {"degraded_shared_edge_direction", "spheres of points; an edge of A is parallel to an edge of B", 10,
     degraded<Degradation::shared_edge_direction>},
    {"degraded_shared_facet_normal", "spheres of points; a facet of A and one of B have the same normal", 10,
     degraded<Degradation::shared_facet_normal>},
    {"degraded_opposite_facet_normals", "spheres of points; a facet of A and one of B have opposite normals", 10,
     degraded<Degradation::opposite_facet_normals>},
    {"degraded_coplanar_facets",
     "spheres of points; a facet of A and one of B lie in one plane, on the same side of it", 10,
     degraded<Degradation::coplanar_facets>},
    {"degraded_axis_aligned_facet", "spheres of points; each body has a facet across a coordinate axis", 10,
     degraded<Degradation::axis_aligned_facet>},
    {"degraded_normal_at_pole", "spheres of points; each body has a facet with the normal (0, 0, 1) or (0, 0, -1)", 10,
     degraded<Degradation::normal_at_pole>},
    {"degraded_normal_on_equator", "spheres of points; each body has a facet whose normal has z = 0", 10,
     degraded<Degradation::normal_on_equator>},
    {"degraded_arc_on_equator", "spheres of points; each body has an edge parallel to the z-axis", 10,
     degraded<Degradation::arc_on_equator>},
    {"degraded_vertical_edge",
     "spheres of points; each body has an edge with y = 0 in its direction: its arc stands upright in the chart", 10,
     degraded<Degradation::vertical_edge>},
    {"degraded_nodes_on_one_vertical",
     "spheres of points; a node of each Gaussian diagram on one vertical of the chart", 10,
     degraded<Degradation::nodes_on_one_vertical>},
    {"degraded_normal_on_arc", "spheres of points; a node of -A in the middle of an arc of B", 10,
     degraded<Degradation::normal_on_arc>},
    {"degraded_flattened_body", "spheres of points; A, B or both are projected into the plane of a facet", 10,
     degraded<Degradation::flattened_body>},
    {"degraded_identical_bodies", "spheres of points; B = A", 10, degraded<Degradation::identical_bodies>},
    {"degraded_tie_by_reflection",
     "spheres of points; both bodies are symmetric about O: every optimum has an opposite one", 10,
     degraded<Degradation::tie_by_reflection>},
    {"degraded_touching_translation", "spheres of points; A is moved by its exact translation: the bodies touch", 10,
     degraded<Degradation::touching_translation>},
    {"degraded_snapped_to_lattice", "spheres of points; coordinates are rounded to a coarse grid", 10,
     degraded<Degradation::snapped_to_lattice>},
    {"approaching_degraded", "spheres of points, broken in any of the ways above, every point moved by about 2^-k", 10,
     approaching_degraded},
    // Hard on purpose, by inverse construction: first the answer, then the bodies.
    {"inverse_facet_vertex",
     "one optimum, of kind facet-vertex; the next facet, opposite, is farther by the factor 1 + 2^-k", 12,
     inverse<FeatureKind::face, FeatureKind::vertex>},
    {"inverse_vertex_facet",
     "one optimum, of kind vertex-facet; the next facet, opposite, is farther by the factor 1 + 2^-k", 12,
     inverse<FeatureKind::vertex, FeatureKind::face>},
    {"inverse_facet_edge",
     "one optimum, of kind facet-edge; the next facet, opposite, is farther by the factor 1 + 2^-k", 12,
     inverse<FeatureKind::face, FeatureKind::edge>},
    {"inverse_edge_facet",
     "one optimum, of kind edge-facet; the next facet, opposite, is farther by the factor 1 + 2^-k", 12,
     inverse<FeatureKind::edge, FeatureKind::face>},
    {"inverse_facet_facet",
     "one optimum, of kind facet-facet; the next facet, opposite, is farther by the factor 1 + 2^-k", 12,
     inverse<FeatureKind::face, FeatureKind::face>},
    {"inverse_edge_edge", "one optimum, of kind edge-edge; the next facet, opposite, is farther by the factor 1 + 2^-k",
     12, inverse<FeatureKind::edge, FeatureKind::edge>},
    {"inverse_tie", "two opposite optima of different kinds", 12, inverse_tie},
    {"inverse_ridge",
     "spheres of points; the nearest facet shares an edge with the next one, farther by the factor 1 + 2^-k", 12,
     inverse_ridge},
    {"rounding_binary32", "the depth is 2^-k ulp above or below, or on, a number of binary32 or half way between two",
     10, rounding<binary32>},
    {"rounding_binary64", "the depth is 2^-k ulp above or below, or on, a number of binary64 or half way between two",
     10, rounding<binary64>},
    // Extremes.
    {"deep",
     "spheres of points about one centre, one up to a thousand times smaller: the depth is nearly the sum of the radii",
     20, deep},
    {"hair_overlap", "one optimum of any kind; depth 2^-k of the size, k up to 200", 10, hair_overlap},
    {"hair_gap", "any two features apart by 2^-k of the size, k up to 200", 10, hair_gap},
    {"stretched", "needles, plates and planks with extents in a ratio of up to 10^9", 20, stretched},
    // ==== shapes ====
    // Random pairs in doubles: deep, shallow, apart, touching.
    {"spheres", "two spheres", corners, pair<ShapeKind::sphere, ShapeKind::sphere>},
    {"capsules", "two capsules", corners, pair<ShapeKind::capsule, ShapeKind::capsule>},
    {"sphere_capsule", "a sphere against a capsule", corners, pair<ShapeKind::sphere, ShapeKind::capsule>},
    {"capsule_box", "a capsule against a box", corners, pair<ShapeKind::capsule, ShapeKind::box>},
    {"capsule_hull", "a capsule against a hull", corners, pair<ShapeKind::capsule, ShapeKind::hull>},
    {"hulls_posed", "two hulls, the same two in every case of a size, in poses by quaternions", corners,
     prepared_hulls},
    {"rounded_boxes", "two boxes with margins", corners, pair<ShapeKind::rounded_box, ShapeKind::rounded_box>},
    {"rounded_hulls", "two hulls with margins", corners, pair<ShapeKind::rounded_hull, ShapeKind::rounded_hull>},
    {"rounded_triangle_sphere", "a triangle with a margin against a sphere", corners,
     pair<ShapeKind::rounded_triangle, ShapeKind::sphere>},
    {"tapered_capsules", "two hulls of two balls", corners,
     pair<ShapeKind::tapered_capsule, ShapeKind::tapered_capsule>},
    {"tapered_capsule_box", "a hull of two balls against a box", corners,
     pair<ShapeKind::tapered_capsule, ShapeKind::box>},
    {"cylinders", "two cylinders", corners, pair<ShapeKind::cylinder, ShapeKind::cylinder>},
    {"cylinder_box", "a cylinder against a box", corners, pair<ShapeKind::cylinder, ShapeKind::box>},
    {"cylinder_capsule", "a cylinder against a capsule", corners, pair<ShapeKind::cylinder, ShapeKind::capsule>},
    {"rounded_cylinders", "two cylinders with margins", corners,
     pair<ShapeKind::rounded_cylinder, ShapeKind::rounded_cylinder>},
    {"cones", "two cones", corners, pair<ShapeKind::cone, ShapeKind::cone>},
    {"cone_box", "a cone against a box", corners, pair<ShapeKind::cone, ShapeKind::box>},
    {"cone_cylinder", "a cone against a cylinder", corners, pair<ShapeKind::cone, ShapeKind::cylinder>},
    {"frusta", "two cones that are cut off", corners, pair<ShapeKind::frustum, ShapeKind::frustum>},
    {"ellipsoids", "two ellipsoids", corners, pair<ShapeKind::ellipsoid, ShapeKind::ellipsoid>},
    {"ellipsoid_box", "an ellipsoid against a box", corners, pair<ShapeKind::ellipsoid, ShapeKind::box>},
    {"ellipsoid_hull", "an ellipsoid against a hull", corners, pair<ShapeKind::ellipsoid, ShapeKind::hull>},
    {"sums", "sums of two shapes", corners, pair<ShapeKind::sum, ShapeKind::sum>},
    {"shapes_halfspace", "a shape of any kind against a half-space", corners, with_plane},
    {"shapes_mixed", "shapes of any two kinds", corners, of_any_kinds<random_pair>},
    {"shapes_stretched", "shapes of any two kinds, each length up to 256 times larger or smaller", corners,
     of_any_kinds<stretched_pair>},
    // By inverse construction: first the contact and the signed depth, then the bodies, in exact
    // rational poses.
    {"inverse_sphere_sphere", "two spheres", corners, of_contacts<sphere_cap, sphere_cap>},
    {"inverse_cap_cap", "the ends of two capsules", corners, of_contacts<capsule_cap, capsule_cap>},
    {"inverse_side_side", "the sides of two capsules: their segments are edge to edge", corners,
     of_contacts<capsule_side, capsule_side>},
    {"inverse_side_face", "a capsule lies on a box", corners, of_contacts<capsule_side, box_face>},
    {"inverse_tapered_sides", "generators of two hulls of two balls", corners, of_contacts<tapered_side, tapered_side>},
    {"inverse_end_faces", "the end faces of two cylinders, in parallel planes", corners,
     of_contacts<cylinder_face, cylinder_face>},
    {"inverse_face_on_face", "a cylinder stands on a box", corners, of_contacts<cylinder_face, box_face>},
    {"inverse_barrels", "two cylinders lie across each other", corners, of_contacts<cylinder_barrel, cylinder_barrel>},
    {"inverse_barrel_on_face", "a cylinder lies on a box", corners, of_contacts<cylinder_barrel, box_face>},
    {"inverse_rim_on_face", "the rim of a cylinder on a box", corners, of_contacts<cylinder_rim, box_face>},
    {"inverse_rim_on_barrel", "the rim of a cylinder on the barrel of another", corners,
     of_contacts<cylinder_rim, cylinder_barrel>},
    {"inverse_rims", "the rims of two cylinders: they touch or are apart", corners,
     of_contacts<cylinder_rim, cylinder_rim>},
    {"inverse_apex_on_face", "the apex of a cone on a box", corners, of_contacts<cone_apex, box_face>},
    {"inverse_apexes", "the apexes of two cones: they touch or are apart", corners, of_contacts<cone_apex, cone_apex>},
    {"inverse_generators", "generators of two cones across each other", corners,
     of_contacts<cone_generator, cone_generator>},
    {"inverse_generator_on_base", "a cone lies on the base of another", corners,
     of_contacts<cone_generator, cone_base>},
    {"inverse_vertex_on_cap", "the corner of a box on a sphere", corners, of_contacts<box_vertex, sphere_cap>},
    {"inverse_edge_on_barrel", "the edge of a box across a cylinder", corners, of_contacts<box_edge, cylinder_barrel>},
    {"inverse_poles", "the poles of two ellipsoids", corners, of_contacts<ellipsoid_pole, ellipsoid_pole>},
    {"inverse_rounded_edges", "edges of two boxes with margins across each other", corners,
     of_contacts<rounded_box_edge, rounded_box_edge>},
    {"inverse_plane", "any contact with a half-space", corners, of_contacts<any_side, plane>},
    {"inverse_shapes", "any two contacts", corners, of_contacts<any_side, any_side>},
    // ==== unions ====
    // Random pieces: deep, touching, apart.
    {"clusters", "hulls of 20 points each, one beside the last", 5, clusters},
    {"clusters_on_lattice", "hulls of points of a coarse lattice: coplanar facets abound", 4, lattice_clusters},
    {"clusters_apart", "clusters with a plane between them", 5, clusters_apart},
    {"box_unions", "boxes with corners on a coarse lattice: ties and seams abound", 5, box_unions},
    {"box_unions_touching", "the same, with a plane between them that both touch", 5, box_unions_touching},
    // Convex bodies in pieces that abut exactly: the depth is that of the whole.
    {"cut_cones", "cut into cones over the facets", 10, cut_cones},
    {"cut_slabs", "cut by parallel planes, at times the same ones for both", 6, cut_slabs},
    {"cut_planes", "cut by random planes", 8, cut_planes},
    {"cut_grids", "boxes cut into cubes or boxes, on one lattice", 8, cut_grids},
    {"cut_repeated", "cut by random planes, with pieces twice, the whole among them, in random order", 6, cut_repeated},
    {"cut_same", "one body twice, cut in the same way or in two", 8, cut_same},
    {"cut_and_whole", "one is cut, the other is a single piece", 8, cut_and_whole},
    // Bodies that hold on to each other.
    {"combs", "two combs, teeth towards each other", 4, combs},
    {"keys", "a key in a keyhole, its bits between the wards of the lock", 2, keys},
    {"slots", "a plate beside one of the slots of its own width", 3, slots},
    {"slots_narrow", "the same with slots that are narrower by 2^-16: no plate fits", 3, slots_narrow},
    {"rings_linked", "two rings of wedges, one through the other: at times with room", 12, rings_linked},
    {"ring_and_rod", "a square rod through a ring: at times with room", 12, ring_and_rod},
    // ==== bodies of the plane ====
    // Random bodies.
    {"plane_random", "hulls of points in a disc; B shifted by up to 1 along each axis", corners, plane_random},
    {"plane_regular", "regular polygons, turned at random", corners, plane_regular},
    {"plane_boxes", "rectangles with corners in {0..4}^2: parallel edges, ties, touching; the size is ignored", 4,
     plane_boxes},
    {"plane_thin", "polygons up to a thousand times longer than wide", corners, plane_thin},
    {"plane_far", "random polygons, 10^3 to 9 10^6 away from the origin along each axis", corners, plane_far},
    {"plane_rounded", "circles, capsules and polygons with margins", corners, plane_rounded},
    {"plane_flat", "points and segments, against each other and polygons", corners, plane_flat},
    // Ties.
    {"plane_ties", "a regular polygon against itself, or a smaller copy about its centre: many optima", corners,
     plane_ties},
    {"plane_near_ties", "a regular polygon against itself, moved by about 2^-k", corners, plane_near_ties},
    {"plane_identical", "a random polygon against itself: its width", corners, plane_identical},
    {"plane_nested", "B is a smaller copy of A inside A", corners, plane_nested},
    // From the contact.
    {"plane_touching", "a vertex or an edge of A touches one of B", 6, plane_touching},
    {"plane_nearly_touching", "the same, apart or overlapping by about 2^-k", 6, plane_nearly_touching},
    {"plane_parallel_edges", "an edge of A in an edge of B, exactly parallel, overlapping by about 2^-k", 6,
     plane_parallel_edges},
    {"plane_tilted_edges", "the same, B's edge tilted by a slope of 2^-k", 6, plane_tilted_edges},
};

constexpr std::span<const Family> of_kind(Kind kind) {
  const auto begin = std::ranges::find(table, kind, &Family::kind);
  const auto end = std::find_if(begin, std::end(table), [kind](const Family& family) { return family.kind() != kind; });
  return {begin, end};
}
static_assert(of_kind(Kind::polytopes).size() + of_kind(Kind::shapes).size() + of_kind(Kind::unions).size() +
                  of_kind(Kind::plane).size() ==
              std::size(table));

/// FNV-1a; gives every family its own stream of random numbers.
std::uint64_t hash(std::string_view text) {
  std::uint64_t value = 0xcbf29ce484222325u;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return value;
}

/// Returns the stream of random numbers for a case of the family.
Random stream_of(std::string_view family, std::uint64_t seed) { return Random(hash(family) ^ Random(seed).next()); }

std::string case_id(std::string_view family, unsigned size, std::uint64_t seed) {
  return std::string(family) + "-n" + std::to_string(size) + "-s" + std::to_string(seed);
}

}  // namespace

Case Family::make(std::uint64_t seed, unsigned size) const {
  if (kind() == Kind::shapes) return make_shapes(seed, size).read();
  Random random = stream_of(name, seed);
  const std::string id = case_id(name, size, seed);
  if (kind() == Kind::polytopes) {
    Bodies bodies = std::get<0>(build)(random, std::max(1u, size));
    return {id, std::move(bodies.a), std::move(bodies.b)};
  }
  if (kind() == Kind::plane) {
    PlanePair pair = std::get<3>(build)(random, size);
    return {id, std::move(pair.a), std::move(pair.b)};
  }
  UnionPair unions = std::get<2>(build)(random, size);
  return {id, files::union_of(std::move(unions.a)), files::union_of(std::move(unions.b))};
}

ShapeCase Family::make_shapes(std::uint64_t seed, unsigned size) const {
  Random random = stream_of(name, seed);
  return {case_id(name, size, seed), std::get<1>(build)(random, size)};
}

std::span<const Family> families(Kind kind) { return of_kind(kind); }

std::span<const Family> all_families() { return table; }

std::vector<std::string_view> family_names() {
  std::vector<std::string_view> names;
  for (const Family& family : table) names.push_back(family.name);
  return names;
}

const Family* find_family(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Family::name);
  return found == std::end(table) ? nullptr : &*found;
}

}  // namespace fathom::families
