// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a body from a file with groups, or from a folder of files; with the faces of their
// meshes, which tell whether each is convex.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/union.hpp"
#include "reference/files/scene_files.hpp"

namespace fathom::files {

/// The mesh files in a folder (of the names that is_mesh_name tells) in the natural order of their
/// names; hidden ones and those in folders within left out. Throws InputError if the folder cannot
/// be read, or holds a named pipe of such a name.
std::vector<std::string> piece_files(const std::string& folder);

/// The union of meshes, or of point sets, each a piece. Its `faces` are those of all pieces:
/// corners count the points of one after another.
Body union_of(const std::vector<Body>& pieces);

/// The same of pieces of which no mesh is known.
Body union_of(Pieces pieces);

/// Whether a piece, of this number in its file or folder, is to be one of a union.
using PieceFilter = std::function<bool(const NamedPiece& piece, std::size_t number)>;

/// The union that read_pieces reads, with its faces; without the pieces that `stays` leaves out.
/// Throws as read_pieces does, and if none is left.
Body read_union(const std::string& path, Decimals decimals, const PieceFilter& stays = {});

/// "a, b, c": at most twelve of the texts, and how many more there are; "none".
std::string listed(const std::vector<std::string>& texts);

/// Whether a file of this name is a mesh for certain: .off .obj .ply .stl .gltf .glb .dae .3mf
bool is_mesh_name(const std::string& name);

/// A path that may end in "#name", which chooses one of the meshes in the file: a group of an OBJ,
/// a solid of an STL, a node or a mesh of a scene.
struct MeshPath {
  std::string file;
  std::optional<std::string> piece;  ///< nullopt: all of the file
};
/// A file that is there is meant, whatever its name; else the shortest part before a '#' that is
/// the path of a file.
MeshPath mesh_path(const std::string& path);

/// All pieces of a file as one mesh.
Body one_mesh(ScenePieces file);

/// What the reader of a body's file had to say about it, a sentence each, wherever the body was
/// moved to. Of scenes: which numbers are taken, and what placed them.
std::vector<std::string> file_notes(const Body& body);

/// What a piece of a union that read_union read is called, wherever the union was moved to: as its
/// group, or its object, or its file in a folder. "" if it has no name, or the union no faces.
std::string piece_name(const Body& body, std::size_t piece);

/// Whether `a` comes before `b` as people count files, piece_2 before piece_10: runs of digits are
/// compared as numbers of any length, all else byte by byte. What differs only in leading zeros is
/// in the order of bytes, so no two texts are equal.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace fathom::files
