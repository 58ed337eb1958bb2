// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of a body from a file with groups, or from a folder of files; with the faces of their
// meshes, which tell whether each is convex.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/union.hpp"

namespace fathom::files {

/// The mesh files in a folder (.off, .obj, .ply, .stl) in the natural order of their names; hidden
/// ones and those in folders within left out. Throws InputError if the folder cannot be read, or
/// holds a named pipe of such a name.
std::vector<std::string> piece_files(const std::string& folder);

/// The union of meshes, or of point sets, each a piece. Its `faces` are those of all pieces:
/// corners count the points of one after another.
Body union_of(const std::vector<Body>& pieces);

/// The same of pieces of which no mesh is known.
Body union_of(Pieces pieces);

/// The union that read_pieces reads, with its faces. Throws as that does.
Body read_union(const std::string& path, Decimals decimals);

/// What a piece of a union that read_union read is called, wherever the union was moved to: as its
/// group, or its object, or its file in a folder. "" if it has no name, or the union no faces.
std::string piece_name(const Body& body, std::size_t piece);

/// Whether `a` comes before `b` as people count files, piece_2 before piece_10: runs of digits are
/// compared as numbers of any length, all else byte by byte. What differs only in leading zeros is
/// in the order of bytes, so no two texts are equal.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace fathom::files
