// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies.
// Output  the intermediate results of the exact method on its way to the depth, as plain numbers:
//         the data of all pictures, schema fathom/stages/1. Places are binary64 numbers, for
//         pixels; counts are exact, and depths are those of penetration_depth.
// Size    linear in the diagrams and in sum |A_i| + |B_i|; the sum P is left out where it is large.
//                                                                        [AGHRS, PENETRATION-DEPTH]
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/answer.hpp"
#include "fathom/body.hpp"
#include "fathom/counters.hpp"
#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "fathom/study.hpp"
#include "fathom/union.hpp"

namespace fathom::stages {

/// A point, a translation or a unit vector.
using Place = std::array<double, 3>;
/// An index of a vertex, an edge, a facet (all within the hull), a node, an arc, a wall or a
/// canonical pair.
using Index = std::uint32_t;
using Indices = std::vector<Index>;

inline double dot(const Place& p, const Place& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
inline Place cross(const Place& p, const Place& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

/// The map from input to places, (input - center) * 2^exponent: it keeps the accuracy of places far
/// from O, and keeps them within binary64.
struct StagedScale {
  Point center;
  long exponent = 0;
};

/// The hull of a body, and its Gaussian diagram: that of -A, that of B. Arc i is edge i, node i is
/// facet i.
struct StagedBody {
  int rank = 0;
  bool sampled = false;  ///< a mesh near a curved body: without diagram
  Indices ids;           ///< of each vertex the index of the input point
  std::vector<Place> vertices;
  std::vector<std::array<Index, 2>> edges;
  std::vector<Indices> facets;  ///< counter-clockwise from outside
  std::vector<Place> nodes;     ///< unit normals, negated for A
  std::vector<std::array<std::optional<Index>, 2>> arcs;
  /// For rank 1 and 2, whose arcs are full and half circles, the unit normal of each arc's circle.
  /// A half circle passes through circle x node.
  std::vector<Place> circles;
};

struct StagedOptimum {
  Place direction, translation;    ///< a unit vector; a translation is on the scale of places
  std::optional<Contact> contact;  ///< by input points, as in Depth; none of shapes without such
};

/// The answer, as the exact method finds it; of shapes as signed_depth does.
struct StagedContact {
  Place direction{}, translation{};  ///< of disjoint bodies: to the contact
  std::optional<Contact> features;   ///< of the first optimum, or of the distance
  std::vector<StagedOptimum> optima;
};

/// The part of an arc in a hemisphere, from left to right.
struct StagedArc {
  Index edge;
  std::optional<Index> from, to;  ///< nodes; none: the arc continues beyond the equator
};

/// A node of this hemisphere, in the chart: longitude atan2(<n,r>, <n,z>) and latitude asin(<n,v>),
/// r = v x z.
struct StagedNode {
  Index node;
  double longitude, latitude;
};

struct StagedDiagram {
  std::vector<StagedArc> arcs;    ///< in height order
  std::vector<StagedNode> nodes;  ///< ascending
};

struct StagedWall {
  bool of_a;
  Index node;
};

struct StagedChart {
  bool upper;
  Place v, z;  ///< the frame, before it is tilted
  StagedDiagram a, b;
  std::vector<StagedWall> walls;  ///< from left to right
};

/// The treatment of a canonical pair by the search for closest lines: it scanned each crossing,
/// cleared all at once, or cut the grid. `none`: there was no search.
enum class PairFate { none, scanned, cleared, cut };

/// The closest lines of a canonical pair.
struct ClosestPair {
  Index a, b;  ///< edges; of ties the first found
  double distance;
  mpq_class squared;  ///< exact, in the unit of the input
};

struct StagedPair {
  Index chart;
  bool stored_of_a, rising;
  Indices a, b;                               ///< edges, in the order of the grid
  std::array<std::optional<Index>, 2> strip;  ///< walls; none: infinity
  std::optional<ClosestPair> closest;         ///< none unless the bodies penetrate, or if all its edges are parallel
  std::uint64_t evaluated = 0;                ///< pairs of lines that the search evaluated
  PairFate fate = PairFate::none;

  [[nodiscard]] std::uint64_t crossings() const { return std::uint64_t{a.size()} * b.size(); }
};

enum class BlockFate { cleared, refined, scanned, won };

/// Rows are indices into StagedPair::a, columns into StagedPair::b; half-open.
struct StagedBlock {
  std::array<Index, 2> rows, columns;
  BlockFate fate;
};

/// The blocks of level 0 are the whole grid. Those of a level partition the refined ones of the
/// level before.
struct StagedLevel {
  std::optional<bool> cut_a;  ///< whether A's chain was cut, else B's; none for level 0
  std::vector<StagedBlock> blocks;
};

/// The cutting of a grid. Blocks that are not refined partition it; exactly one of them contains
/// the pair's closest lines: it is `won`.
struct StagedCutting {
  Index pair;
  bool winner;       ///< whether the pair holds the optimum; else it is the largest one
  bool as_searched;  ///< whether the search cut it, in these sizes; else it is cut finer, for a picture
  std::vector<StagedLevel> levels;
};

enum class WinnerKind { edges, facet_of_a, facet_of_b };
enum class StagedFeatureKind { vertex, edge, facet };

struct StagedFeature {
  StagedFeatureKind kind;
  Index index;
};

/// The step that found the first optimum.
struct StagedWinner {
  WinnerKind kind;
  /// For edges: the canonical pair with their crossing; none if their arcs touch without crossing.
  std::optional<Index> pair;
  StagedFeature a, b;
};

enum class SumKind { none, p, q, sampled };
enum class SumFacetKind { facet_of_a, facet_of_b, edges, merged };

struct StagedFacet {
  Indices vertices;  ///< counter-clockwise from outside
  Place normal;
  double distance;
  mpq_class squared;
  SumFacetKind kind;
  std::vector<std::uint32_t> a, b;  ///< input points that span the features
  Indices pairs;                    ///< canonical pairs with one of its crossings
  bool optimal = false;
};

/// P, or the certificate's polytope Q inside it. O is at 0, because the center cancels in
/// differences.
struct StagedSum {
  SumKind kind = SumKind::none;
  std::vector<Place> vertices;
  std::vector<StagedFacet> facets;  ///< by ascending distance
};

struct StagedInvolved {
  std::vector<std::vector<std::uint32_t>> a, b;  ///< input points of each feature
  std::vector<std::string> decided_by;           ///< monomials of the perturbation
  std::optional<ShapeInvolved> shapes = {};      ///< of shapes, which have no such points, one of each
};

struct StagedCoincidence {
  std::string_view kind;
  std::uint64_t count = 0;
  std::vector<StagedInvolved> listed;
};

struct StagedMonomial {
  std::string name;
  std::uint64_t count;
};

/// The number of calls of a predicate by the topology, whether or not the bodies overlap; `exact`
/// counts those that floating point could not decide, and `zero` those whose result was 0.
struct StagedDecision {
  std::string_view predicate;
  std::uint64_t calls = 0, exact = 0, zero = 0;
  std::vector<StagedMonomial> monomials;
};

/// A count and the paper's bound for it.
struct StagedBound {
  std::string_view stage, what;
  std::uint64_t count;
  std::string_view bound;
  double bound_value;
  std::string_view source;
};

struct Stages {
  std::string id;
  std::optional<Status> status;      ///< nullopt: bounds of a shape do not decide it
  std::optional<double> depth;       ///< the nearest binary64; nullopt unless penetrating, or beyond binary64
  std::optional<mpq_class> squared;  ///< nullopt if irrational, or if only bounds are known
  StagedScale scale;
  StagedBody a, b;
  StagedContact contact;
  std::vector<StagedChart> charts;
  std::vector<StagedPair> pairs;
  std::optional<StagedCutting> cutting;
  std::optional<StagedWinner> winner;
  StagedSum sum;
  std::vector<StagedCoincidence> coincidences;
  std::vector<StagedCoincidence> cores;  ///< for shapes with polytopes as cores: the coincidences of the cores
  std::vector<StagedDecision> decided;   ///< of polytopes, or of such cores
  Counters counters;                     ///< of the exact run, as in Depth
  std::vector<StagedBound> bounds;
  /// Set with StageOptions::times.
  std::vector<std::pair<std::string, double>> seconds;
  std::vector<std::string> left_out;  ///< sentences
};

struct StageOptions {
  bool times = false;  ///< measure the seconds of each stage: the result differs from run to run
  Monitor* monitor = nullptr;
  std::size_t listed = StudyOptions{}.listed;  ///< the most coincidences of a kind that are listed
  /// The most pairs of a normal and an edge for which normals on arcs are searched: a second or
  /// two.
  std::uint64_t most_pairs = 50'000'000;
};

/// Returns the stages of two bodies of any kind and rank. Throws as penetration_depth and
/// signed_depth do.
Stages stages_of(const Body& a, const Body& b, const StageOptions& options = {});

/// Returns what pictures of two convex bodies of the plane need: outlines, and the contact of
/// `answer`, which is theirs. The stages are those of bodies of space.
Stages stages_in_plane(const Body& a, const Body& b, const Answer& answer);

/// Returns one line of JSON without its newline, pure ASCII: stages.schema.json.
std::string to_json(const Stages& stages);

// ---- unions ----

// Input   two unions of convex pieces, with the answer about them.
// Output  their data for pictures, as plain numbers: the pieces, every shortest translation with
//         the features that touch, and the differences P_ij of pieces that reach into the ball
//         around O. A moved by t overlaps B exactly if t lies in the interior of some P_ij. Schema
//         fathom/union_stages/1. Places are binary64 numbers, for pixels; distances are exact.
//                                                                         [proofs/unions_search.md]

/// The hull of a piece.
struct StagedPiece {
  Indices ids;  ///< of each vertex the index of its point in the piece
  std::vector<Place> vertices;
  std::vector<std::array<Index, 2>> edges;
  std::vector<Indices> facets;  ///< counter-clockwise from outside
};

/// Two pieces in contact after A has moved.
struct StagedTouch {
  Index a, b;       ///< the pieces
  Place direction;  ///< a unit vector: from B to A, across a plane between them
  Contact contact;  ///< by points of the pieces
};

/// A translation of A: a shortest one out of the overlap, the one of length 0, or the one to the
/// contact.
struct StagedUnionWay {
  Place translation;
  bool clearance;
  std::vector<StagedTouch> touching;
};

/// P_ij, the differences b - a of points of a piece of A and one of B.
struct PieceSum {
  Index a, b;                   ///< the pieces
  bool inside = false;          ///< whether O lies in its interior: the pieces overlap
  mpq_class squared;            ///< of the distance of O from its boundary
  double distance = 0;          ///< the same, in the unit of places
  Indices touches;              ///< ways after which the pieces are in contact
  std::vector<Place> vertices;  ///< empty if it is not drawn; O is at 0
  std::vector<Indices> facets;  ///< counter-clockwise from outside
  std::vector<Place> normals;   ///< of the facets: unit vectors
  /// A facet, and a way whose end lies in its plane; only ways after which the pieces touch.
  std::vector<std::array<Index, 2>> through;
};

struct UnionStages {
  std::string id;
  Status status = Status::disjoint;
  StagedScale scale;
  std::vector<StagedPiece> a, b;
  std::vector<StagedUnionWay> ways;
  std::vector<PieceSum> sums;  ///< if penetrating: first those that touch after a way, then the others, deepest first
  std::vector<std::string> left_out;
};

/// Throws std::invalid_argument as union_depth does, and if `depth` is not complete; Interrupted if
/// the monitor stops it. `dimension`: 2 of bodies of the plane, whose sums are left out.
UnionStages stages_of(const Pieces& a, const Pieces& b, const UnionDepth& depth, Monitor* monitor = nullptr,
                      unsigned dimension = 3);

/// Returns one line of JSON without its newline, pure ASCII: union_stages.schema.json.
std::string to_json(const UnionStages& stages);

// Input   the stages of two bodies.
// Output  their charts as an SVG file, in longitude and latitude, where walls are vertical and a
//         hemisphere fits a square. A's arcs are solid and B's dashed; highlighted arcs are thick.
//         Places are computed in doubles: the exact data are elsewhere.
//                                                               [AGHRS, section 2.2, "Computing F"]
//
// First arcs of great circles, their parts in a hemisphere, and their projection.

/// The points cos(t) from + sin(t) side for t in [begin, end]; `from` and `side` are orthogonal
/// unit vectors.
struct SphereArc {
  Place from, side;
  double begin, end;

  [[nodiscard]] Place at(double t) const;
};

/// Returns an arc of a diagram; nullopt if its ends are too close to each other to be
/// distinguished.
std::optional<SphereArc> arc_of(const StagedBody& body, Index edge);

/// Returns the parts in the hemisphere around z; all of the arc if it lies on the equator.
std::vector<SphereArc> parts_in(const SphereArc& arc, const Place& z);

/// A place in pixels.
struct Pixel {
  double x, y;
};

using Projection = std::function<Pixel(const Place&)>;

/// Returns the arc as a line of pixels, with an error of less than half a pixel.
std::vector<Pixel> polyline(const SphereArc& arc, const Projection& project);

/// One hemisphere as a square of longitude and latitude.
struct ChartPanel {
  std::string content;   ///< elements, with the upper left corner at the origin
  std::string caption;   ///< a sentence that describes the panel, as plain text
  std::string left_out;  ///< sentences on omitted parts, as plain text; may be empty
};

/// Returns the canonical pair that a picture of this chart highlights unless another is requested:
/// that with the optimum, else the one with the most crossings, the first of several.
std::optional<Index> pair_to_light(const Stages& stages, Index chart);

ChartPanel chart_panel(const Stages& stages, Index chart, std::optional<Index> pair);

/// Returns both charts side by side, as a file. Throws std::invalid_argument if the stages have no
/// charts.
std::string charts_file(const Stages& stages);

}  // namespace fathom::stages
