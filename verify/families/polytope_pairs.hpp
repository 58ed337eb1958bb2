// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of polytopes, made for the families. `n` is the number of points of each body where nothing
// else is said. Random poses; crossed bundles; pairs made from their contact; degenerate pairs;
// pairs made from their answer; extremes; the
// small world.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "verify/families/solids.hpp"

namespace fathom::families {

// ---- random bodies, and pairs of them in random poses ----

/// Uniform in the unit ball, multiples of 2^-20.
Body random_ball_body(Random& random, unsigned n);
/// Near the unit sphere (within 2^-20), multiples of 2^-20: all points are extreme unless two fall
/// together.
Body random_sphere_body(Random& random, unsigned n);
/// Integer points of {0..side}^3; duplicates, collinear and coplanar points abound.
Body random_lattice_body(Random& random, unsigned n, long side = 3);

Bodies random_ball(Random& random, unsigned n);
Bodies random_sphere(Random& random, unsigned n);
Bodies random_lattice(Random& random, unsigned n);
/// Two balls with O well outside their difference.
Bodies random_disjoint(Random& random, unsigned n);

/// Rational half extents in [1/4, 2], rational rotations.
Bodies boxes_posed(Random& random, unsigned n);
/// The same, both moved by one vector of integers from 10^3 to 9 10^6, as a world with one origin
/// has them: binary32 is coarse there.
Bodies far_boxes(Random& random, unsigned n);
Bodies far_sphere(Random& random, unsigned n);
/// Integer corners in {0..4}^3, axes parallel to the coordinates': coplanar facets and parallel
/// edges.
Bodies boxes_aligned(Random& random, unsigned n);
/// Two of the five platonic solids, each turned and scaled.
Bodies platonic_posed(Random& random, unsigned n);
/// The same without turning: many symmetries survive.
Bodies platonic_aligned(Random& random, unsigned n);
/// A prism or antiprism each, n vertices or one more, turned at random.
Bodies prisms_posed(Random& random, unsigned n);

/// Extents 1, 2^-20, 2^-20, both about O.
Bodies needles(Random& random, unsigned n);
/// Extents 1, 1, 2^-20, both about O.
Bodies plates(Random& random, unsigned n);
Bodies needle_and_plate(Random& random, unsigned n);

// ---- bundles: fans ----

// Fans: bodies whose Gaussian diagram is a bundle of long arcs, nearly parallel; and pairs of fans
// across each other.

/// A point of a convex chain: abscissa and height, concave as a function of the abscissa.
struct ChainPoint {
  mpq_class along, height;
};
using Chain = std::vector<ChainPoint>;

/// The chain in the yz-plane, closed by (+-side, 0, -below). Every edge of the chain is an edge of
/// the hull as long as the chain lies above the two points, and its arc reaches as far across the
/// plane as slope below / side.
Body fan(const Chain& chain, const mpq_class& side, const mpq_class& below);

/// A's fan: the same in the xz-plane, upside down, so that it is -A that has its chain on top.
Body opposing_fan(const Chain& chain, const mpq_class& side, const mpq_class& below);

/// A's fan and B's, B moved so that the highest point of P, where both chains have height 0, is at
/// `top`.
Bodies crossed(const Chain& a, const Chain& b, const mpq_class& side, const mpq_class& below, const Point& top);

/// The even curve z(p) whose tangent with slope -x is z = x^2 / 2 * quadratic + x^4 * quartic - x
/// p. In the chart z = 1 a body with this outline has the support function x^2 / 2 * quadratic +
/// x^4 * quartic, convex as long as quadratic + 12 quartic x^2 > 0.
struct Outline {
  mpq_class quadratic, quartic;
};

/// `count` values in [-width, width], ascending, one at random in the middle half of each of
/// `count` equal parts: multiples of 2^-60, at least width / count apart.
std::vector<mpz_class> spread_slopes(Random& random, unsigned count, const mpq_class& width);
inline constexpr long slope_bits = 60;

/// Returns the chain of the outline's tangents with the negatives of these slopes, cut off at the
/// abscissae -reach and reach. `slopes` has at least two elements, made by spread_slopes for this
/// width. There is one edge for each slope. Corners are rounded to a grid that keeps the chain
/// strictly convex if the outline bends about as a unit circle does: multiples of 2^-least_bits if
/// (count / width)^2 is less than 2^(least_bits - 2). least_bits is at most 180.
Chain tangent_chain(const Outline& outline, const std::vector<mpz_class>& slopes, const mpq_class& width,
                    const mpq_class& reach, long least_bits = 50);

// ---- bundles across each other ----

// Pairs whose Gaussian diagrams cross like a grid: K = Theta(mn) facets of P, the worst case of
// AGHRS. A fan is a convex chain in a vertical plane, closed by two points below, one on each side
// of the plane: the arcs of the chain's edges are long and nearly parallel. A's fan opens downwards
// in the xz-plane, B's upwards in the yz-plane, so every arc of the one crosses every arc of the
// other, and near its top P is the sum of the two chains. `n` is the number of points of each
// chain.

/// Chains on circles of radius 1 (random angles in +-45 degrees), O at a depth below 1: one clear
/// optimum.
Bodies crossed_fans(Random& random, unsigned n);

/// Chains on the parabola z = -t^2 at integer multiples of a unit: the top of P is a paraboloid of
/// revolution with O on its axis, beyond the centre of curvature, so the minimum runs along a whole
/// circle. Facets (i, j) and (i', j') are equally far if (2i+1)^2 + (2j+1)^2 = (2i'+1)^2 +
/// (2j'+1)^2: exact ties. Integer coordinates.
Bodies crossed_parabolas(Random& random, unsigned n);

/// The same with chains at random places on the parabola: near ties along a circle. Coordinates are
/// binary64 numbers.
Bodies crossed_random_parabolas(Random& random, unsigned n);

/// Chains on the twisted cubics (t^3 / 16, t, -t^2) and (t, t^3 / 16, -t^2), |t| <= 1, at random
/// places: the directions of no three edges of a chain lie in one plane, and no arc is upright or
/// level. As x y (x^2 + y^2) / 128 breaks its circle of minima, P has two separate minima, near (1,
/// -1) and (-1, 1) in the chart. They tie up to the random places of the edges, to about 1 / n^2.
/// Coordinates are binary64 numbers.
Bodies crossed_twists(Random& random, unsigned n);

/// Chains on circles of radius 1 over a small patch, O at depth 1: the distances of all (n-3)^2
/// facets of the patch agree to about w^4 / 4, where w = 1/64 is the patch's half width, that is to
/// about 1.5e-8. Not random.
Bodies crossed_patch(Random& random, unsigned n);

/// Near-regular n-gonal prisms of radius 1 along the y-axis and the x-axis; O close to the part of
/// P that their rims make.
Bodies crossed_prisms(Random& random, unsigned n);

/// The same with corners at random angles (except for eight), and with random heights of the
/// prisms. Coordinates are binary64 numbers.
Bodies crossed_random_prisms(Random& random, unsigned n);

/// Points of thin bands around full circles in the xz-plane and the yz-plane.
Bodies crossed_bands(Random& random, unsigned n);

// ---- bundles with ties ----

// Crossed fans whose n^2 pairs of chain edges, one of each body, all have nearly the same distance:
// the worst that can happen to a search for the closest lines. `n` is the number of edges of each
// chain.
//
// In the chart (x, y) of the direction of the patch A's chain edges lie on the lines x = x_i and
// B's on y = y_j, with slopes in [-w, w], one at random in each of n equal parts. Their distance is
// (1 + g(x) + g(y)) / sqrt(1 + x^2 + y^2). A fan's support function g can depend on one variable
// only, so x^2 y^2 / 4 cannot be matched; g = (1 - w^2/4) x^2 / 2 - x^4 / 8 comes nearest and
// leaves, up to terms of sixth order, the saddle (x^2 - w^2/2) (y^2 - w^2/2) / 4: a spread of w^4 /
// 8, with maxima at the centre and in the four corners, and four minima, at (+-w, 0) and (0, +-w).
// Beyond the patch both chains run straight on, so no other part of P is as near to O. No arc is
// upright or level in the chart of (0, 0, 1), and no two ties are exact by symmetry.

/// w = 1/32: whatever n, the distances agree to about 1.2e-7, relatively. Neighbouring distances
/// come closer as n grows. Coordinates are binary64 numbers below n = 2^19.
Bodies crossed_ties(Random& random, unsigned n);

/// w = (2n)^(-1/2): the distances agree to about 1/(32 n^2), while slopes are n^(-3/2) apart.
/// Coordinates are binary64 numbers up to n = 2^15, and multiples of 2^-63 at n = 10^6.
Bodies crossed_shrinking_ties(Random& random, unsigned n);

/// w = 1/n: the distances agree to about 1/(8 n^4), rounding included to 1/(2 n^4) or to 2^-47 if
/// that is more. This is less than the square of the gap between neighbouring slopes. Coordinates
/// are binary64 numbers up to n = 2^11, and multiples of 2^-83 at n = 10^6.
Bodies crossed_vanishing_ties(Random& random, unsigned n);

/// The same with corners rounded to multiples of 2^-k, for a random k between 50 and 90: smooth
/// ties with noise at 2^-k, above or below them. Where that would not keep a chain convex it is
/// rounded less, as crossed_vanishing_ties is.
Bodies crossed_noisy_ties(Random& random, unsigned n);

// ---- fillets ----

// Rounded edges across each other, as meshes of machined parts have them.

/// Two bars, bent to an arc, with the edge along the arc rounded off: each body is the hull of a
/// chain of about n / 2 edges swept along the three corners of a fillet's cross-section, and of two
/// points far below. The three copies of a chain edge are parallel, and their arcs in the Gaussian
/// diagram follow one another; the faces between them are parallelograms, exactly plane. The bars
/// cross at the angle with the cosine 3/5: K = Theta(n^2), in several grids, with some crossings of
/// chain edges and cross-section edges beside them. Along one bisector of the angle P bends less
/// than a sphere about O, along the other more: the distance has a saddle in the middle and two
/// separate minima of about 0.98, one on each side. They tie except for a shift of O by at most
/// 2^-16 and for the random places of the edges: to about 2^-16 + 1 / n^2. Coordinates are binary64
/// numbers.
Bodies crossed_fillets(Random& random, unsigned n);

// ---- contacts ----

// Pairs constructed from their contact: first the two features and the gap are chosen, then the
// bodies are built around them. Both features lie in parallel planes with normal +z (then the pair
// is turned): A's is A's lowest face, B's is B's highest, and each body widens away from it. With
// overlap g, h(z) = g. The features' projections along z meet.

enum class FeatureKind { vertex, edge, face };

/// The two features touch, edges crossing transversally; `n` is the number of further points of
/// each body, at least 4.
Bodies touching(FeatureKind a, FeatureKind b, Random& random, unsigned n);

/// Two parallel edges share a segment; the bodies lie on either side of a plane through it.
Bodies touching_parallel_edges(Random& random, unsigned n);

/// The pair of `touching` with overlap 2^-k, 4 <= k <= 40. When the features span a facet of P (an
/// edge and an edge, or a face and anything), the depth is 2^-k and this direction its only
/// optimum.
Bodies overlapping(FeatureKind a, FeatureKind b, Random& random, unsigned n);

/// The pair of `touching` with the gap 2^-k, 4 <= k <= 60, or overlapping by it: a random one of
/// the nine kinds.
Bodies nearly_touching(Random& random, unsigned n);

/// A face of A in a face of B, by part of each, as an engine has them: boxes, prisms of about n
/// points, or hulls of n further points, at least 4; all coordinates binary64. A's face is turned
/// out of B's by the angle 2 atan(tilt / 2), 0 <= tilt <= 1/100, about a line in it that lies 2^-k
/// deep in B, 5 <= k <= 10; then every coordinate is rounded to the nearest. What is exact: B's
/// face lies across a coordinate axis; with tilt 0 A's does too, and the depth is 2^-k with this
/// one optimum, of kind facet-facet. With any tilt the bodies penetrate.
Bodies faces(const mpq_class& tilt, Random& random, unsigned n);

// ---- degenerate pairs: ties, shared features, lower-dimensional bodies, extreme coordinates ----

/// A solid against itself (platonic, prism or box; turned): P is symmetric about O, so every
/// optimum has a twin, and most have more.
Bodies exact_ties(Random& random, unsigned n);
/// The same, with B moved by a small integer vector times 2^-k, 10 <= k <= 200: the ties are broken
/// by about 2^-k.
Bodies near_ties(Random& random, unsigned n);
/// Boxes along the axes with depths 1, 1 + 2^-k, 1 + 2^-j along three axes, turned.
Bodies near_tie_boxes(Random& random, unsigned n);

/// A random body against itself: the depth is its width, and every node and arc of the two diagrams
/// occurs twice (A's opposite B's).
Bodies identical(Random& random, unsigned n);
/// B = -A: all nodes, arcs and faces of the two Gaussian diagrams coincide.
Bodies mirrored(Random& random, unsigned n);
/// B = A scaled by a factor in [1/4, 3/4] and moved a little: B inside A, or nearly.
Bodies nested(Random& random, unsigned n);
/// B = a scaled and moved copy of -A (common normals on one side) or of A (opposite normals).
Bodies common_normals(Random& random, unsigned n);
/// Prisms with one common axis: many parallel edges, coinciding arcs, facets of kind facet-facet.
Bodies parallel_edges(Random& random, unsigned n);
/// Random bodies with repeated points, points on edges, in facets and in the interior added.
Bodies redundant_points(Random& random, unsigned n);

/// Bodies of the given ranks (0 point, 1 segment, 2 polygon, 3 solid) with small half-integer
/// coordinates. Three in four have a common point, at a vertex or halfway between two; half of the
/// segments and polygons are parallel to each other.
Bodies flat(int rank_a, int rank_b, Random& random, unsigned n);

/// random_sphere at the scale 1e-300, at 1e300, and with extents 1e300, 1, 1e-300.
Bodies tiny_coordinates(Random& random, unsigned n);
Bodies huge_coordinates(Random& random, unsigned n);
Bodies uneven_coordinates(Random& random, unsigned n);
/// Each coordinate has a random sign and a random exponent between 1e-300 and 1e300.
Bodies wild_coordinates(Random& random, unsigned n);

// ---- lenses ----

// Two bodies constructed from their answer: flat lenses, one in the other, that come apart soonest
// in two opposite directions. The features that meet there and the distances are chosen first.
//                                                                                  [docs/golden.md]

/// The features of A and of B that meet in one direction. A vertex and a vertex, or a vertex and an
/// edge, span no facet of P.
struct Meeting {
  FeatureKind a, b;
};

/// One of the six kinds of facets of P.
Meeting random_meeting(Random& random);

/// B lies between the planes through b_bottom n and b_top n that are orthogonal to n, A between
/// those through a_bottom n and a_top n. In direction n the distance is (b_top - a_bottom) |n|, in
/// direction -n it is (a_top - b_bottom) |n|, which gives the bodies their size.
struct Lenses {
  Vector n;              ///< not zero
  Meeting above, below;  ///< what meets in direction n: A's bottom and B's top; and in direction -n
  mpq_class b_top, b_bottom, a_top, a_bottom;  ///< each body's top above its bottom
};

/// The two bodies, with about `points` points each. Let r be the distance in direction -n, that in
/// direction n at most r, and each body's thickness between a quarter and three quarters of the sum
/// of both. Then all facets of P in other directions are farther than r (1 + 2^-8), and the two
/// facets, if the features that meet span them, hold the foot points of O; if the distance in
/// direction n is negative, it is the distance of the bodies. Coordinates are multiples of powers
/// of 2 with about 20 bits, except for the four numbers times n.
Bodies lenses(const Lenses& plan, Random& random, unsigned points);

/// A random integer direction with components up to `bound`.
Vector random_integer_direction(Random& random, long bound);

/// The quotient sqrt(square) / sqrt(other), rounded down to a multiple of 2^-bits; both positive.
mpq_class quotient_of_roots(const mpq_class& square, const mpq_class& other, long bits);

// ---- near ties ----

// Near ties by inverse construction: the kind of the nearest facet, its direction and the gap to
// the next one are chosen, then the bodies are built around them. The next facet is of a random
// kind.                                                                            [docs/golden.md]

/// Lenses with one optimum, where this feature of A meets that of B; the next nearest facet of P
/// lies opposite, farther by the factor 1 + 2^-k, 8 <= k <= 200, and nothing else within 1 + 2^-8.
/// The direction is a random integer vector.
Bodies inverse(FeatureKind a, FeatureKind b, Random& random, unsigned n);

/// The same with an exact tie of two different kinds.
Bodies inverse_tie(Random& random, unsigned n);

// Near ties of facets that share an edge: O is placed close to an edge of P, between its two
// facets.                                                                          [docs/golden.md]

/// Two spheres of points, B moved so that the two facets of P at an edge are the nearest ones,
/// mostly of kind edge-edge. The distance of the second is larger by the factor 1 + 2^-k (to within
/// 2^-k-16), 8 <= k <= 200. If no such place is found near a few edges, the spheres are not moved;
/// no seed is known for which this happens.
Bodies inverse_ridge(Random& random, unsigned n);

// ---- rounding ----

// Depths that are hard to round: within 2^-k ulp of a point where the correctly rounded value
// changes, or exactly on it.
//                                                                                  [docs/golden.md]

/// A binary floating-point format: normal numbers 1.f * 2^e with `digits` bits and least_exponent
/// <= e <= greatest_exponent.
struct FloatFormat {
  long digits, least_exponent, greatest_exponent;
};
inline constexpr FloatFormat binary32{24, -126, 127};
inline constexpr FloatFormat binary64{53, -1022, 1023};

/// Lenses whose depth lies near a number of the format (where rd and ru change) or a point halfway
/// between two neighbours (where rn does): 2^-k ulp above or below it, or on it. Half of the cases
/// lie along a coordinate axis, and 1 <= k <= 50: their coordinates are binary64 numbers, except in
/// one case of eight, where the depth is at the end of the format's range (subnormal, or about to
/// overflow). In the other half the direction is random and 1 <= k <= 200; there the depth is
/// usually irrational, and its distance about 3/4 of 2^-k ulp.
Bodies rounding_boundary(const FloatFormat& format, Random& random, unsigned n);

// ---- extremes of depth and of shape ----                                         [docs/golden.md]

/// Two sphere-like bodies about one centre, B scaled by 2^-j, 0 <= j <= 10: the depth is nearly the
/// sum of the radii, and facets of P all around nearly tie.
Bodies deep(Random& random, unsigned n);

/// Lenses that overlap by 2^-k of their size, 41 <= k <= 200: one optimum, of a random kind.
Bodies hair_overlap(Random& random, unsigned n);

/// Lenses apart by 2^-k of their size, 61 <= k <= 200, with any of the nine pairs of features
/// nearest to each other.
Bodies hair_gap(Random& random, unsigned n);

/// Sphere-like bodies about one centre, each stretched to extents with a ratio of 10^j, 4 <= j <=
/// 9, as a needle, a plate or a plank, then turned.
Bodies stretched(Random& random, unsigned n);

// degrade.cpp: breaks general position on purpose, in one named way at a time: makes any pair of
// bodies degenerate and keeps its looks. Features are made to coincide by exact linear maps, as
// close to the identity as possible.                                               [docs/golden.md]

/// In the chart, z = (0, 0, 1) is the pole and v = (0, 1, 0) the vertical. The diagrams are those
/// of B and of -A.
enum class Degradation {
  duplicate_points,        ///< some points are given again
  collinear_points,        ///< each body gets points inside its edges
  coplanar_points,         ///< each body gets a facet with four corners or more, and a point inside it
  shared_vertex,           ///< a vertex of A is a vertex of B
  shared_edge_direction,   ///< an edge of A is parallel to an edge of B
  shared_facet_normal,     ///< a facet of A and one of B have the same outward normal
  opposite_facet_normals,  ///< a facet of A and one of B have opposite normals: a common node of the two diagrams
  coplanar_facets,         ///< a facet of A and one of B lie in one plane, on the same side of it
  axis_aligned_facet,      ///< each body has a facet with a coordinate axis as its normal
  normal_at_pole,          ///< each body has a facet with the normal z or -z
  normal_on_equator,       ///< each body has a facet whose normal has z = 0
  arc_on_equator,          ///< each body has an edge parallel to z
  vertical_edge,  ///< each body has an edge with y = 0 in its direction: the arc's circle passes through the vertical v
  nodes_on_one_vertical,  ///< a node of each diagram on one great circle through v
  normal_on_arc,          ///< a node of -A in the middle of an arc of B
  flattened_body,         ///< A, B or both are projected into the plane of one of their facets
  identical_bodies,       ///< B = A
  tie_by_reflection,      ///< both bodies are made symmetric about O: every optimum has an opposite one
  touching_translation,   ///< A is moved by its exact translation: the bodies touch
  snapped_to_lattice,     ///< coordinates are rounded to a grid of 4 to 16 steps across the pair
};

struct DegradationName {
  Degradation way;
  std::string_view name;         ///< letters and underscores, as above
  std::string_view description;  ///< one line
};

/// All ways, in the order of the enumeration.
std::span<const DegradationName> degradations();

/// Returns `generic`, degraded in this way, with the id "<id>-<name>". The result is the same on
/// every machine. If there is a choice of features to coincide, the seed makes it. A body that
/// lacks the feature (a point has no edge) stays as it is. Bodies must not be empty.
Case degrade(const Case& generic, Degradation way, std::uint64_t seed);

// Almost degenerate pairs: a degenerate pair whose points are each moved by at most 2^-k.
//                                                                                  [docs/golden.md]

/// Moves every point of both bodies by its own displacement: three random multiples of 2^-(k+20),
/// each at most 2^-k in size. As k grows, the pair tends to `degenerate`, but all coincidences are
/// gone: parallel edges, coplanar points, ties, touching, flatness. Exact, and the same on every
/// machine. The id is "<id>-k<k>-s<seed>".
Case approach(const Case& degenerate, unsigned k, std::uint64_t seed);

// The catalogue, the degradations and the approach to them, as families.

/// An entry of the catalogue; the size is ignored.
Bodies from_catalogue(Random& random, unsigned n);

/// An entry of the catalogue with at most 16 points a body, each point moved by at most 2^-k, 4 <=
/// k <= 200; the size is ignored.
Bodies approaching_catalogue(Random& random, unsigned n);

/// random_sphere with at least 4 points, degraded in this way.
Bodies degraded(Degradation way, Random& random, unsigned n);

/// A pair of spheres of points, degraded in a random way, then each point moved by at most 2^-k, 4
/// <= k <= 200.
Bodies approaching_degraded(Random& random, unsigned n);

// ---- the small world ----

// Every pair of tetrahedra with corners in {0, 1, 2}^3, flat ones included, once up to the 48
// symmetries of that cube. A pair and its swap are two pairs: libraries answer them by different
// ways.

/// Four different points of {0, 1, 2}^3, in lexicographic order.
using SmallTetrahedron = std::array<std::array<int, 3>, 4>;

struct SmallPair {
  SmallTetrahedron a, b;
  friend auto operator<=>(const SmallPair&, const SmallPair&) = default;
};

/// The number of pairs, up to symmetry. [Burnside's lemma, in the test]
std::uint64_t small_world_size();

/// Pair `number`, from 0. Pairs ascend lexicographically, and each is the least of all
/// its images. Throws std::out_of_range. May be called by many threads at once.
SmallPair small_pair(std::uint64_t number);

/// The same as a case, "small_world::<number>".
Case small_case(std::uint64_t number);

/// What is special about a pair, exactly. First how the bodies meet: one of "disjoint",
/// "touching_vertex_edge" and so on, by the least faces of A and of B that touch,
/// "contact_facet_vertex" and so on, by the one optimum of bodies that penetrate, or "ties" if it
/// has several. Then, of "flat_a", "flat_b", "shared_vertices", "parallel_edges",
/// "coincident_normals", "equal_normals" and "coplanar_facets", what holds; the last four as in a
/// Study.
std::vector<std::string_view> small_kinds(const SmallPair& pair);

/// All words of small_kinds, in this order.
std::vector<std::string_view> all_small_kinds();

}  // namespace fathom::families
