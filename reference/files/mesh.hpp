// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files as exact points: OFF, OBJ, PLY, STL and plain x y z lines.                           [docs/command_line.md]
#pragma once

#include <string>
#include <string_view>

#include "kernels/number/parse.hpp"
#include "reference/files/body.hpp"

namespace fathom {

/// The layouts that are understood. PLY and STL are text or binary, as the file itself says.
enum class MeshFormat { off, obj, ply, stl, xyz };

/// The points of the mesh in `path`, exactly: binary floats and hexadecimal floats as they are, integers and p/q too;
/// decimals by `decimals`: the nearest binary64 (what other programs read), or the decimal value itself.
/// Ids are the order of appearance; repeated points stay (an STL repeats each corner). Of faces, only the indices are
/// checked; what else a mesh may hold (normals, colours, texture) is passed over, and without faces it is a point set.
/// The format is told by the extension (.off .obj .ply .stl .xyz .txt .pts), else by the first bytes.
/// InputError, with file and line (in binary files, the byte), for anything missing, truncated, out of range or not a number.
Body read_mesh(const std::string& path, Decimals decimals);

/// The same for a mesh in memory; `name` is its file name: it may tell the format and appears in messages.
Body parse_mesh(std::string_view bytes, const std::string& name, Decimals decimals);

/// The same for a known format.
Body parse_mesh(std::string_view bytes, const std::string& name, Decimals decimals, MeshFormat format);

}  // namespace fathom
