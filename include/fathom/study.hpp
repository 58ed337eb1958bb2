// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two finite point sets with rational coordinates; each stands for its convex hull. Or two
//         shapes.
// Output  what is degenerate about the pair: how often each predicate of the exact method met an
//         exact zero, and what decided then; and the coincidences of the bodies by name, with the
//         features involved. Of shapes the coincidences.                     [docs/command_line.md]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/counters.hpp"
#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/numbers.hpp"
#include "fathom/point.hpp"
#include "fathom/shape.hpp"
#include "fathom/signed_depth.hpp"

namespace fathom {

/// What can coincide, or lie specially in the frame. "Nodes" and "arcs" are those of the Gaussian
/// diagrams of -A and of B: a node is a facet's normal (negated for A), an arc an edge. The equator
/// is z = 0, a vertical a half of a great circle through (0, 1, 0): the frame before it is tilted.
enum class Coincidence {
  parallel_edges,       ///< an edge of A and an edge of B
  parallel_edges_of_a,  ///< two edges of A
  parallel_edges_of_b,  ///< two edges of B
  coincident_normals,   ///< facets of A and B with opposite outward normals: one node in both diagrams
  equal_normals,        ///< facets of A and B with the same outward normal
  coplanar_facets,      ///< those of the two kinds above that lie in one plane
  normals_on_arcs,      ///< a node of one diagram inside an arc of the other: a facet of one body, an edge of the other
  nodes_on_equator,     ///< a facet of A or B
  arcs_on_equator,      ///< an edge of A or B, parallel to the z-axis
  crossings_on_equator,   ///< edges of A and B whose arcs cross there, inside both and not in one great circle
  nodes_on_one_vertical,  ///< two facets of either body, coincident normals included; not those on the equator
  arcs_on_verticals,      ///< an edge of A or B, with y constant along it
  touching_features,      ///< of touching bodies: the faces in the direction that proves the touch
  ties,                   ///< the contacts of all optima, if there is more than one
  count
};
/// In the order of Coincidence.
inline constexpr std::array<std::string_view, static_cast<std::size_t>(Coincidence::count)> coincidence_names{
    "parallel_edges",        "parallel_edges_of_a",
    "parallel_edges_of_b",   "coincident_normals",
    "equal_normals",         "coplanar_facets",
    "normals_on_arcs",       "nodes_on_equator",
    "arcs_on_equator",       "crossings_on_equator",
    "nodes_on_one_vertical", "arcs_on_verticals",
    "touching_features",     "ties"};

/// A vertex, an edge or a facet: ascending 0-based indices of the input points that span it,
/// extreme points only, of equal points the lowest index.
using Feature = std::vector<std::uint32_t>;

/// The features that take part in one coincidence: one, or two of one body or of both.
struct Involved {
  std::vector<Feature> a, b;  ///< those of A, those of B
  friend bool operator==(const Involved&, const Involved&) = default;
};

/// All coincidences of one kind.
struct Coincidences {
  std::uint64_t count = 0;       ///< how many there are, listed or not
  std::vector<Involved> listed;  ///< the first of them, as many as were asked for
};

/// How large a body's convex hull is.
struct BodySize {
  int rank = 0;                                       ///< dimension of the body: 0 a point, 1 a segment, 2 flat, 3
  std::uint64_t vertices = 0, edges = 0, facets = 0;  ///< of the hull
};

/// What is degenerate about two bodies, and their depth.
struct Study {
  Depth depth;    ///< as penetration_depth finds it
  BodySize a, b;  ///< of the two bodies
  /// Of the exact method's run. If the bodies do not penetrate, of its topological part alone:
  /// charts, vertex-facet pairs, canonical subsets.
  PredicateCounts predicates{};
  std::array<Coincidences, static_cast<std::size_t>(Coincidence::count)> coincidences;  ///< in the order of Coincidence
  /// Returns the coincidences of this kind.
  [[nodiscard]] const Coincidences& operator[](Coincidence kind) const {
    return coincidences[static_cast<std::size_t>(kind)];
  }
};

/// How much to list, and who watches.
struct StudyOptions {
  std::size_t listed = 20;     ///< the most coincidences of a kind that are listed; counts are always complete
  Monitor* monitor = nullptr;  ///< is called with the progress and may stop the work; may be null
  std::size_t support_calls = SignedDepthOptions{}.support_calls;  ///< of shapes: as of signed_depth
};

/// Finds what is degenerate about two bodies. Exact, for bodies of every rank. Near-linear in the
/// size of the bodies, except for normals_on_arcs and arcs_on_equator, which look at all pairs, and
/// for the depth itself. Throws as penetration_depth does.
Study study(std::span<const Point> a, std::span<const Point> b, const StudyOptions& options = {});

/// What a key of TierCounts::decided stands for: "1", "a", "E11 b^2". Eij is an entry of the matrix
/// that moves -A; a, b, c tilt the frame.
///                                                                         [proofs/perturbation.md]
std::string monomial_name(std::uint64_t monomial);

// ---- shapes ----

/// What can coincide of two shapes, bodies that need not be polytopes. A margin belongs to the
/// body: so axes, radii and faces are those of the body, with its margin. A face is a flat one: a
/// facet, the end face of a cylinder, the plane of a half-space. Looked for are the faces in the
/// planes of discs, those of hulls of points, and in sums those that straight lines of two terms
/// span. Centres and axes are those of terms that are symmetric one by one.
///                                                                      [proofs/shapes.md, "Study"]
enum class ShapeCoincidence {
  equal_bodies,       ///< A and B are described by the same numbers
  concentric,         ///< their centres of symmetry are one point
  centre_on_axis,     ///< the centre of symmetry of one is on the other's axis of revolution, and they are not coaxial
  coaxial,            ///< their axes of revolution are one line
  parallel_axes,      ///< their axes are parallel: coaxial ones too
  orthogonal_axes,    ///< their axes are orthogonal
  intersecting_axes,  ///< their axes meet in one point
  equal_radii,        ///< of balls, discs, margins
  parallel_faces,     ///< the normals of two faces are parallel
  coplanar_faces,     ///< those that lie in one plane
  generators_along_faces,  ///< a face of one, and the edge or generator that the other would show it if moved there
  supporting_faces,        ///< a face of one whose plane supports the other from outside
  parallel_generators,     ///< of cylinders and capsules
  tangent_generators,      ///< a plane is tangent to both along parallel generators or edges: of cylinders from either
                           ///< side, else between them
  touching_cores,          ///< of bodies with margins: every direction of a cone is optimal
  distance_of_radii,       ///< bodies with margins touch, as the distance of their cores is the sum of the radii
  vertex_on_face,          ///< this and what follows of bodies that touch: in a direction in which no others meet
  apex_on_face,
  rim_on_face,        ///< a point of the rim of a disc
  tangent_to_face,    ///< a point of a smooth part, as of a sphere
  generator_on_face,  ///< or an edge
  face_on_face,
  touching_features,  ///< these features, whatever they are
  count
};
/// In the order of ShapeCoincidence.
inline constexpr std::array<std::string_view, static_cast<std::size_t>(ShapeCoincidence::count)>
    shape_coincidence_names{"equal_bodies",
                            "concentric",
                            "centre_on_axis",
                            "coaxial",
                            "parallel_axes",
                            "orthogonal_axes",
                            "intersecting_axes",
                            "equal_radii",
                            "parallel_faces",
                            "coplanar_faces",
                            "generators_along_faces",
                            "supporting_faces",
                            "parallel_generators",
                            "tangent_generators",
                            "touching_cores",
                            "distance_of_radii",
                            "vertex_on_face",
                            "apex_on_face",
                            "rim_on_face",
                            "tangent_to_face",
                            "generator_on_face",
                            "face_on_face",
                            "touching_features"};

/// What of a body takes part in a coincidence.
struct ShapeFeature {
  std::string_view what;       ///< "body", "core", "centre", "axis", "radius", "face", "edge", "generator", "vertex",
                               ///< "apex", "rim point", "smooth point"
  Vector direction;            ///< primitive: along an axis; outward where the body is seen from; else 0
  std::optional<Point> point;  ///< a centre, or a point of an axis
  std::optional<Surd> length;  ///< of a radius
};

/// One feature of each body.
struct ShapeInvolved {
  ShapeFeature a, b;  ///< that of A, that of B
};

/// All coincidences of one kind.
struct ShapeCoincidences {
  std::uint64_t count = 0;            ///< how many there are, listed or not
  std::vector<ShapeInvolved> listed;  ///< the first of them, as many as were asked for
};

/// What a shape is made of, as it was given.
struct ShapeSize {
  bool half_space = false;                                    ///< then there are no terms
  std::uint64_t terms = 0, points = 0, discs = 0, balls = 0;  ///< in the core
  mpq_class radius;                                           ///< around the core
};

/// What coincides of two shapes, and their signed depth.
struct ShapeStudy {
  SignedDepth depth;  ///< as signed_depth finds it
  ShapeSize a, b;     ///< of the two shapes
  /// in the order of ShapeCoincidence
  std::array<ShapeCoincidences, static_cast<std::size_t>(ShapeCoincidence::count)> coincidences;
  /// The features that face each other in an optimal direction: of cores that touch, in one inside
  /// the cone of all. nullopt if the depth is not known exactly.
  std::optional<ShapeInvolved> contact;
  std::optional<Study> cores;  ///< of the cores without radii, if both are polytopes
  /// Returns the coincidences of this kind.
  [[nodiscard]] const ShapeCoincidences& operator[](ShapeCoincidence kind) const {
    return coincidences[static_cast<std::size_t>(kind)];
  }
};

/// Finds what coincides of two shapes. Exact: all is decided in rationals and square roots of such.
/// Time grows with the number of faces of one body times the size of the other. Throws as
/// signed_depth does.
ShapeStudy study(const Shape& a, const Shape& b, const StudyOptions& options = {});

}  // namespace fathom
