// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes in files of scenes (glTF, GLB, COLLADA, 3MF), read by Assimp.
// Input   the bytes of a file, its name, and its folder if buffers may be read that lie beside it.
// Output  a mesh for each node that has some, placed by the transforms above it, exactly.
// Assimp is not trusted: what it is given has been checked (scene_checks.cpp), it runs in a process
// of its own that can open no file (scene_process.cpp), and what it returns is checked again.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/body.hpp"
#include "reference/files/mesh_formats.hpp"

namespace fathom::files {

/// Whether it is one of these.
inline bool is_scene(MeshFormat format) { return format >= MeshFormat::gltf; }

/// "glTF", "COLLADA" or "3MF".
std::string_view scene_word(MeshFormat format);

/// A file whose parts that matter are there and agree.
struct CheckedScene {
  MeshFormat format;
  std::string name;                           ///< for messages
  std::string_view bytes;                     ///< of the file
  std::map<std::string, std::string> beside;  ///< the bytes of buffers in other files, by their URIs
  std::optional<std::uint64_t> faces;         ///< how many its nodes show; nullopt if that was not counted
  std::vector<std::string> notes;             ///< what is applied, or left out; a sentence each
};

/// Throws InputError with the place and what was expected there. `folder`: where buffers may lie
/// beside the file; null if none may be read. No other file is read, whatever the bytes say.
CheckedScene checked_scene(std::string_view bytes, const std::string& name, MeshFormat format,
                           const std::string* folder);

/// What Assimp makes of a file, as it is: nothing is joined, sorted or left out.
struct AssimpScene {
  struct Mesh {
    std::string name;
    std::vector<std::array<float, 3>> points;
    MeshFaces faces;
  };
  /// A node that has meshes.
  struct Node {
    std::string name;
    std::vector<std::array<float, 16>> matrices;  ///< row by row; those of the nodes above it, its own last
    std::vector<std::uint32_t> meshes;            ///< indices into `meshes`
  };
  std::string version;  ///< of Assimp: "5.2"
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
};

/// Throws InputError if Assimp cannot read it, crashes, or needs too much time or memory; and if it
/// is not there.
AssimpScene imported(const CheckedScene& scene);

/// The pieces of a file, and what its reader has to say: which numbers they are and what moved
/// them; a sentence each.
struct ScenePieces {
  std::vector<NamedPiece> pieces;
  std::vector<std::string> notes;
};

/// Throws InputError as the functions above do, and for a file without faces, with numbers that are
/// not finite or with corners that are no vertices.
ScenePieces parse_scene(std::string_view bytes, const std::string& name, MeshFormat format, const std::string* folder);

}  // namespace fathom::files
