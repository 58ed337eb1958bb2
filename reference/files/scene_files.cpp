// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes as meshes: their nodes, placed by exact products of the matrices that Assimp returns.
#include "reference/files/scene_files.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/messages.hpp"
#include "kernels/number/rational.hpp"
#include "reference/files/pose.hpp"

namespace fathom::files {
namespace {

/// The product of the matrices of a node and those above it. Each is affine.
Pose product_of(const AssimpScene::Node& node, const std::string& file) {
  Pose all{};
  for (std::size_t i = 0; i < 3; ++i) all[i][i] = 1;
  for (const std::array<float, 16>& m : node.matrices) {
    const bool finite = std::ranges::all_of(m, [](float x) { return std::isfinite(x); });
    if (!finite || m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
      throw InputError(file, 0,
                       "node " + kernels::shown(node.name) +
                           ": expected a transform of finite numbers with the last row "
                           "0 0 0 1, found another");
    const Pose above = all;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        all[i][j] = j == 3 ? above[i][3] : mpq_class(0);
        for (std::size_t k = 0; k < 3; ++k) all[i][j] += above[i][k] * exact(m[4 * k + j]);
      }
  }
  return all;
}

bool is_mirror(const Pose& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
         0;
}

bool is_identity(const Pose& m) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (m[i][j] != (i == j ? 1 : 0)) return false;
  return true;
}

void require_sound(const AssimpScene& scene, const CheckedScene& from) {
  for (const AssimpScene::Mesh& mesh : scene.meshes) {
    const std::string place = "mesh " + kernels::shown(mesh.name);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      for (const float x : mesh.points[i])
        if (!std::isfinite(x))
          throw InputError(from.name, 0,
                           place + ", vertex " + std::to_string(i) + ": expected finite numbers, found " +
                               (std::isnan(x) ? "nan" : "inf"));
    std::size_t begin = 0;
    for (std::size_t i = 0; i < mesh.faces.ends.size(); begin = mesh.faces.ends[i++]) {
      for (std::size_t k = begin; k < mesh.faces.ends[i]; ++k)
        if (const std::uint32_t corner = mesh.faces.corners[k]; corner >= mesh.points.size())
          throw InputError(from.name, 0,
                           place + ", face " + std::to_string(i) + ": expected a vertex index below " +
                               std::to_string(mesh.points.size()) + ", found " + std::to_string(corner));
    }
  }
}

/// In binary64 if it is one of its numbers.
Coordinate shortest(const mpq_class& value) {
  const std::optional<double> same = kernels::in_binary64(value);
  return same ? Coordinate(*same) : Coordinate(value);
}

/// The meshes of a node as one, of the vertices that have faces. Lines and points are left out.
Body body_of(const AssimpScene& scene, const AssimpScene::Node& node, const Pose& pose, bool& lines) {
  CollectedPoints points;
  MeshFaces faces;
  const bool moved = !is_identity(pose), mirror = is_mirror(pose);
  for (const std::uint32_t number : node.meshes) {
    const AssimpScene::Mesh& mesh = scene.meshes.at(number);
    std::vector<std::uint32_t> corners, ends;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : mesh.faces.ends) {
      const auto from = mesh.faces.corners.begin() + begin, to = mesh.faces.corners.begin() + end;
      lines = lines || end < begin + 3;
      if (end >= begin + 3) {
        corners.insert(corners.end(), from, to);
        if (mirror) std::reverse(corners.end() - (to - from), corners.end());  // so that it looks outwards again
        ends.push_back(static_cast<std::uint32_t>(faces.corners.size() + corners.size()));
      }
      begin = end;
    }
    const auto before = static_cast<std::uint32_t>(points.size());
    for (const std::uint32_t i : renumbered(corners)) {
      const auto& [x, y, z] = mesh.points[i];
      if (!moved) {
        points.add({static_cast<double>(x) + 0.0, static_cast<double>(y) + 0.0, static_cast<double>(z) + 0.0});
        continue;
      }
      const Point p = placed({exact(x), exact(y), exact(z)}, pose);
      points.add({shortest(p.x), shortest(p.y), shortest(p.z)});
    }
    for (const std::uint32_t corner : corners) faces.corners.push_back(before + corner);
    faces.ends.insert(faces.ends.end(), ends.begin(), ends.end());
  }
  return points.empty() ? Body() : mesh_body(std::move(points), std::move(faces));
}

}  // namespace

std::string_view scene_word(MeshFormat format) {
  return format == MeshFormat::collada ? "COLLADA" : format == MeshFormat::threemf ? "3MF" : "glTF";
}

ScenePieces parse_scene(std::string_view bytes, const std::string& file, MeshFormat format, const std::string* folder) {
  CheckedScene from = checked_scene(bytes, file, format, folder);
  const AssimpScene scene = imported(from);
  require_sound(scene, from);
  ScenePieces result;
  result.notes.push_back("read as " + std::string(scene_word(format)) + " by Assimp " + scene.version +
                         ": its numbers, in binary32, are taken exactly");
  std::ranges::move(from.notes, std::back_inserter(result.notes));
  bool lines = false;
  std::uint64_t faces = 0;
  for (const AssimpScene::Node& node : scene.nodes) {
    const Pose pose = product_of(node, file);
    NamedPiece piece{body_of(scene, node, pose, lines), node.name, scene.meshes[node.meshes.front()].name};
    if (piece.mesh.points.empty()) continue;
    for_each_face(*piece.mesh.faces, piece.mesh.points.size(), [&](auto) { ++faces; });
    if (!is_identity(pose)) {
      const std::string kind = pose_note({.matrix = pose}, false);
      piece.note = "the transform of node " + kernels::shown(node.name) + " is applied, exactly" +
                   (kind.empty() ? "" : ": " + kind);
    }
    result.pieces.push_back(std::move(piece));
  }
  if (from.faces && faces != *from.faces)
    throw InputError(file, 0,
                     "expected " + std::to_string(*from.faces) + " faces, found " + std::to_string(faces) +
                         " in what Assimp makes of them");
  if (lines) result.notes.emplace_back("its points and lines are left out");
  if (result.pieces.empty()) throw InputError(file, 0, "expected a scene with at least one face, found none");
  return result;
}

}  // namespace fathom::files
