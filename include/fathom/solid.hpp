// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a closed mesh, which need not be convex.
// Output  convex pieces whose union is its solid, exactly.                      [proofs/solids.md]
//
// The winding number of a mesh at a point is how often its surface goes around it. The mesh is
// closed if no edge is left open; its solid is the closure of the set of all points with a positive
// winding number, which must be negative nowhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/body.hpp"

namespace fathom {

/// A closed mesh, and convex pieces that tile its solid.
struct Solid {
  /// A convex piece: its facets, each by its corners, counter-clockwise from outside.
  struct Piece {
    std::vector<std::vector<std::uint32_t>> facets;  ///< indices into `points`
  };

  std::vector<Point> points;  ///< each once: those of the mesh, then those that cuts made
  /// The mesh: its triangles, and of each larger face the fan from its first corner. Those without
  /// an area are left out.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// A piece around which the surface goes k times is listed k times. Neighbours are near one
  /// another: the list is halved, and its halves are, by the medians of their places.
  std::vector<Piece> pieces;
  bool turned = false;         ///< the faces of the mesh looked inwards; `triangles` look outwards
  bool overlaps = false;       ///< the surface goes around some points more than once
  std::size_t bent_faces = 0;  ///< faces whose corners do not lie in one plane
  /// The mesh as it was given, by whose indices and numbers answers name its features; no points
  /// and null if it is not known.
  GivenPoints mesh_points = {};
  std::shared_ptr<const MeshFaces> mesh_faces = nullptr;  ///< its faces
};

/// Cuts the solid of a mesh into convex pieces. Exact, whatever the mesh looks like: corners are
/// the same where their coordinates are, however they are numbered; components may touch, overlap
/// and lie in cavities of others; edges may meet faces or have more than two of them; a face that
/// is there once each way is not there; points that are no corners do not count. A mesh that is
/// inside out as a whole is turned. The same mesh gives the same pieces. Throws
/// std::invalid_argument, with a sentence that names a place, if the body is no mesh with faces, is
/// not closed, or its winding number is negative somewhere and positive elsewhere, or if the solid
/// is empty.
Solid solid_of(const Body& mesh);

/// How many of its points are corners of the mesh: the first.
std::size_t given_points(const Solid& solid);

/// The volume of the solid: what is covered several times counts once. Exact.
mpq_class volume(const Solid& solid);

/// The pieces as a union's (fathom/union.hpp): their corners, those of one that is listed several
/// times once.
Pieces pieces_of(const Solid& solid);

/// The solid of a mesh as a body: the union of its pieces. Throws as solid_of does.
Body solid_body(const Body& mesh);

/// What its mesh has that people may not expect, a sentence each: faces that are not flat, that
/// looked inwards, or that go around some points more than once.
std::vector<std::string> notes(const Solid& solid);

/// The pieces as an OBJ file, one group each, for read_pieces, which finds the same points: where a
/// coordinate is no integer it is written as a ratio p/q.
std::string pieces_obj(const Solid& solid);
/// The text of a certificate that the pieces tile what the mesh encloses, which checkers read:
/// format 5, verify/check/FORMAT.md. It lists the points that are used; triangles, pieces and
/// facets stand in it in their order. Whether it is true is for the checkers to say: it is, if the
/// solid is what its type promises. Throws std::out_of_range for an index that names no point.
std::string certificate_text(const Solid& solid, std::string_view id = {});

/// How far convex pieces are from tiling a solid. Volumes are exact.
struct PieceCoverage {
  mpq_class missing;                  ///< of the solid, what no piece covers
  mpq_class outside;                  ///< of what pieces cover, what is not in the solid
  mpq_class overlap;                  ///< what the volumes of the pieces sum to beyond that of their union
  std::vector<mpq_class> outside_of;  ///< for each piece: of it, what is not in the solid
  std::optional<Point> uncovered;     ///< a point in the interior of the solid and in no piece, if some is missing
  std::optional<Point> stray;         ///< a point in the interior of a piece, not in the solid, if some is outside

  /// Whether the union of the pieces is the solid.
  [[nodiscard]] bool same_union() const { return missing == 0 && outside == 0; }
  /// Whether they tile it: they do not overlap either.
  [[nodiscard]] bool tiles() const { return same_union() && overlap == 0; }
  /// The first of the pieces of which most is outside; nullopt if nothing is.
  [[nodiscard]] std::optional<std::size_t> most_outside() const;
};

/// Compares the union of convex pieces, each the hull of its points, with a solid. Exact. Numbers
/// are long where many pieces are cut. Throws std::invalid_argument, with the number of the piece,
/// if one is flat or has no points, and if there are no pieces or a coordinate is not in lowest
/// terms.
PieceCoverage coverage(const Solid& solid, const Pieces& pieces);

}  // namespace fathom
