// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two unions of convex pieces, with the answer about them.
// Output  what pictures of them show, as plain numbers: the pieces, every shortest translation with
//         what touches, and the differences P_ij of pieces that reach into the ball around O. A
//         moved by t overlaps B exactly if t lies in the interior of some P_ij. Schema
//         fathom/union_stages/1. Places are binary64 numbers, for pixels; distances are exact.
//                                                                         [proofs/unions_search.md]
#pragma once

#include <string>
#include <vector>

#include "fathom/union.hpp"
#include "view/stages/stages.hpp"

namespace fathom::stages {

/// The hull of a piece.
struct StagedPiece {
  Indices ids;  ///< of each vertex the index of its point in the piece
  std::vector<Place> vertices;
  std::vector<std::array<Index, 2>> edges;
  std::vector<Indices> facets;  ///< counter-clockwise from outside
};

/// Two pieces in contact once A has moved.
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
  Indices touches;              ///< ways at whose ends the pieces are in contact
  std::vector<Place> vertices;  ///< none if it is not drawn; O is at 0
  std::vector<Indices> facets;  ///< counter-clockwise from outside
  std::vector<Place> normals;   ///< of the facets: unit vectors
  /// a facet, and a way whose end lies in its plane; of those at whose ends the pieces touch
  std::vector<std::array<Index, 2>> through;
};

struct UnionStages {
  std::string id;
  Status status = Status::disjoint;
  StagedScale scale;
  std::vector<StagedPiece> a, b;
  std::vector<StagedUnionWay> ways;
  std::vector<PieceSum> sums;  ///< if penetrating: first those that touch, then the others, deepest first
  std::vector<std::string> left_out;
};

/// Throws std::invalid_argument as union_depth does, and if `depth` is not complete; Interrupted if
/// the monitor stops it.
UnionStages stages_of(const Pieces& a, const Pieces& b, const UnionDepth& depth, Monitor* monitor = nullptr);

/// One line of JSON without its newline, pure ASCII: union_stages.schema.json.
std::string to_json(const UnionStages& stages);

}  // namespace fathom::stages
