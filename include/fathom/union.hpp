// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies, each the union of convex pieces.
// Output  the exact penetration depth of the two unions, squared, with every optimum.
//                                                                                [proofs/unions.md]
//
// Pieces may overlap, and abut: where two of them meet in a common face, the body has no gap. A + t
// and B overlap if their interiors have a common point, and the depth is the least |t| for which
// they do not. A path from O to t is not asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"

namespace fathom {

/// How to compute the depth of unions. The answer does not depend on it.
struct UnionOptions {
  /// is called with the progress and may stop the work, which then ends with an enclosure; may be
  /// null
  Monitor* monitor = nullptr;
  bool bounds = true;  ///< whether UnionDepth::bounds is found
};

/// A piece of A and a piece of B that touch.
struct PieceContact {
  std::uint32_t a, b;  ///< the pieces' indices
  /// primitive, in the interior of the cone of all planes between the two pieces: points from B to
  /// A
  Vector direction;
  Contact contact;  ///< the faces of the two pieces that meet, by the indices of points in the pieces
  /// Of a body that is the solid of a mesh (fathom/solid.hpp), in exact_answer: what of the mesh
  /// holds the contact, as pieces are made by cuts: of a point the vertex, else the edges, else the
  /// faces; of a segment or polygon all that hold a part of it. Else none.
  std::vector<MeshFeature> mesh_a = {}, mesh_b = {};
};

/// A shortest way out.
struct UnionOptimum {
  Point translation;  ///< moving A by it, the interiors are disjoint
  /// Whether translations as near as one likes leave a gap between the bodies. False for an exact
  /// fit: all around it the bodies overlap or touch, as a key does in a slot of its own width.
  bool clearance;
  std::vector<PieceContact> contacts;  ///< of all pairs of pieces that touch after the translation, sorted by a, then b
};

/// How far apart two unions are.
struct UnionDistance {
  std::uint32_t a, b;  ///< the first pair of pieces that are nearest
  Distance distance;   ///< of these pieces, and of the unions
  /// As in PieceContact, of all points of the pieces that are nearest.
  std::vector<MeshFeature> mesh_a = {}, mesh_b = {};
};

/// What simpler measures say: deepest_pair <= depth^2 <= hulls.
struct UnionBounds {
  mpq_class deepest_pair;  ///< the largest squared depth of a piece of A and a piece of B; if the work was stopped, of
                           ///< those it came to
  std::uint32_t a = 0, b = 0;  ///< the first pair that has it; 0 and 0 if no two pieces overlap
  mpq_class hulls;             ///< the squared depth of the convex hulls of the unions
};

/// What a search did.
struct UnionCounters {
  std::uint64_t nodes = 0;           ///< cells that were split
  std::uint64_t nearest_points = 0;  ///< least-norm problems of cells that were solved
  std::uint64_t pairs = 0;           ///< pairs of pieces: all that there are
  std::uint64_t pairs_touched = 0;   ///< of these, looked at closely: boxes or a direction did not tell
};

/// The answer about two unions.
struct UnionDepth {
  Status status = Status::disjoint;  ///< touching if interiors are disjoint but pieces meet
  bool complete = true;  ///< false if the monitor stopped the search: then `low` and `high` enclose the answer
  mpq_class low, high;   ///< low <= depth^2 <= high, equal if complete; 0 unless penetrating
  /// in lexicographic order of translations, all if complete; if touching the one with translation
  /// 0
  std::vector<UnionOptimum> optima;
  std::optional<UnionDistance> apart;  ///< if disjoint
  std::optional<UnionBounds> bounds;   ///< if asked for
  UnionCounters counters;              ///< what the search did

  /// depth^2. Throws std::logic_error unless complete.
  [[nodiscard]] const mpq_class& squared() const;
};

/// Returns whether two unions, whose pieces have interiors, penetrate, touch or are disjoint, and
/// how deep or how far apart they are. Exact, and complete in its ties. No bound on the time is
/// claimed: it grows with what lies of the boundaries of differences of pieces within the depth of
/// O. Throws std::invalid_argument if a body has no pieces, a piece is flat (the message names it)
/// or a coordinate is not in lowest terms; Interrupted if the work is stopped before the depth of
/// the hulls is known.
UnionDepth union_depth(const Pieces& a, const Pieces& b, const UnionOptions& options = {});

/// Returns the pieces of a body: those that it has, or a polytope as the only one. Throws
/// std::invalid_argument for a shape.
Pieces pieces_of(const Body& body);

// ---- pieces from files ----

/// Returns the convex pieces of a body in an OBJ file: for each object (a line "o" begins a new
/// one) and group in it (lines "g") the corners of its faces, in the order of their numbers. Groups
/// come in the order of their first faces; a file without them is one piece. The solids of an STL
/// file and the nodes of a scene are pieces in the same way. Of a folder, the pieces of all files
/// in it that end in .off, .obj, .ply, .stl, .gltf, .glb, .dae and .3mf, in the natural order of
/// their names, piece_2 before piece_10. "file#name" is one piece, as for read_mesh. Throws
/// InputError of fathom/files.hpp, with file and line, as read_mesh does, and if there are no
/// faces, or no files.
Pieces read_pieces(const std::string& path, Decimals decimals = Decimals::binary64);

/// The same for an OBJ file in memory; `name` appears in messages.
Pieces parse_pieces(std::string_view text, const std::string& name, Decimals decimals = Decimals::binary64);

}  // namespace fathom
