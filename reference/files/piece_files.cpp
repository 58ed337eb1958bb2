// SPDX-License-Identifier: GPL-3.0-or-later
// Folders of pieces in their natural order, and their union. The reader of groups is in
// text_formats.cpp.
#include "reference/files/piece_files.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include "fathom/solid.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/text.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

/// Takes the run of digits from the front of `text`; returns it without leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end =
      static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), kernels::is_decimal_digit) - text.begin());
  std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

Pieces points_of_pieces(const std::vector<NamedPiece>& pieces) {
  Pieces result;
  for (const NamedPiece& piece : pieces) result.push_back(piece.mesh.points.exact());
  return result;
}

std::string folder_of(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Its groups, its solids or the nodes of its scene; of other formats, the mesh.
ScenePieces pieces_of_file(const std::string& file, Decimals decimals) {
  const std::string bytes = read_file(file), folder = folder_of(file);
  const std::optional<MeshFormat> format = bytes.empty() ? std::nullopt : mesh_format(bytes, file);
  if (format && is_scene(*format)) return parse_scene(bytes, file, *format, &folder);
  if (format == MeshFormat::obj) return {parse_obj_pieces(bytes, file, decimals), {}};
  if (format == MeshFormat::svg) return {parse_svg_pieces(bytes, file, decimals), {}};
  if (format == MeshFormat::stl) return {parse_stl_pieces(bytes, file, decimals), {}};
  ScenePieces result;
  result.pieces.push_back({parse_mesh(bytes, file, decimals), ""});
  return result;
}

/// The piece of this name; of scenes the node, or else the node that shows the mesh of this name.
NamedPiece named_piece(ScenePieces& all, const std::string& file, const std::string& wanted) {
  std::vector<NamedPiece*> found;
  for (std::string NamedPiece::*const of : {&NamedPiece::name, &NamedPiece::other_name})
    for (NamedPiece& piece : all.pieces)
      if (found.empty() || found.front()->*of == wanted)
        if (piece.*of == wanted) found.push_back(&piece);
  if (found.size() == 1) return std::move(*found.front());
  std::vector<std::string> names;
  for (const NamedPiece& piece : all.pieces)
    names.push_back(piece.name.empty() ? "one without a name" : kernels::shown(piece.name));
  throw InputError(file, 0,
                   "expected one mesh named " + kernels::shown(wanted) + ", found " +
                       (found.empty() ? "none" : std::to_string(found.size())) + " among " + listed(names));
}

/// The notes on the pieces, after those on the file.
std::vector<std::string> all_notes(ScenePieces& file) {
  constexpr std::size_t most_told = 4;
  std::size_t placed = 0;
  for (const NamedPiece& piece : file.pieces)
    if (!piece.note.empty() && ++placed <= most_told) file.notes.push_back(piece.note);
  if (placed > most_told)
    file.notes.push_back("so are those of " + kernels::counted(placed - most_told, "more node", "more nodes"));
  return std::move(file.notes);
}

/// The pieces of a file, or the one that the path names.
ScenePieces pieces_of_path(const std::string& path, Decimals decimals) {
  const MeshPath chosen = mesh_path(path);
  ScenePieces found = pieces_of_file(chosen.file, decimals);
  if (chosen.piece) {
    NamedPiece one = named_piece(found, chosen.file, *chosen.piece);
    found.pieces.clear();
    found.pieces.push_back(std::move(one));
  }
  return found;
}

ScenePieces pieces_in_files(const std::string& path, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  ScenePieces all;
  const bool in_folder = is_folder(path);
  for (const std::string& file : in_folder ? piece_files(path) : std::vector{path}) {
    ScenePieces found = pieces_of_path(file, decimals);
    for (const std::string& note : all_notes(found))
      all.notes.push_back(in_folder ? std::filesystem::path(file).filename().string() + ": " + note : note);
    for (NamedPiece& piece : found.pieces) {
      if (in_folder && piece.name.empty()) piece.name = std::filesystem::path(file).filename().string();
      all.pieces.push_back(std::move(piece));
    }
  }
  if (all.pieces.empty())
    throw InputError(path, 0,
                     "expected a folder with mesh files (.off, .obj, .ply, .stl, .gltf, .glb, .dae, .3mf), the pieces, "
                     "found none there");
  return all;
}

/// Deletes the faces of a body, which all its copies share, wherever they were moved to; and holds
/// what the pieces of a union are called, and the notes of the reader.
struct FileFacts {
  std::vector<std::string> names, notes;
  void operator()(const MeshFaces* faces) const { delete faces; }
};

void keep(FileFacts facts, Body& body) {
  if (body.faces) body.faces = std::shared_ptr<const MeshFaces>(new MeshFaces(*body.faces), std::move(facts));
}

/// Adds the faces of a piece to those of the pieces before, which have `before` points.
void add_faces(const MeshFaces& of_piece, std::size_t points, std::uint32_t before, MeshFaces& all) {
  const auto corners = static_cast<std::uint32_t>(all.corners.size());
  const bool in_order = of_piece.corners.empty(), triangles = of_piece.ends.empty();
  const std::size_t count = in_order ? points : of_piece.corners.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    all.corners.push_back(before + (in_order ? i : of_piece.corners[i]));
    if (triangles && i % 3 == 2) all.ends.push_back(corners + i + 1);
  }
  for (const std::uint32_t end : of_piece.ends) all.ends.push_back(corners + end);
}

}  // namespace

std::string listed(const std::vector<std::string>& texts) {
  constexpr std::size_t most = 12;
  std::string result;
  for (std::size_t i = 0; i < texts.size() && i < most; ++i) result += (i > 0 ? ", " : "") + texts[i];
  if (texts.size() > most) result += " and " + std::to_string(texts.size() - most) + " more";
  return texts.empty() ? "none" : result;
}

bool natural_less(std::string_view a, std::string_view b) {
  std::string_view p = a, q = b;
  while (!p.empty() && !q.empty()) {
    if (kernels::is_decimal_digit(p.front()) && kernels::is_decimal_digit(q.front())) {
      const std::string_view m = take_number(p), n = take_number(q);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
      continue;
    }
    if (p.front() != q.front()) return p.substr(0, 1) < q.substr(0, 1);  // as unsigned bytes
    p.remove_prefix(1);
    q.remove_prefix(1);
  }
  return p.empty() != q.empty() ? p.empty() : a < b;
}

std::vector<std::string> piece_files(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code fault;
  for (std::filesystem::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault)) {
    const std::string name = entry->path().filename();
    std::error_code unknown;  // then reading it says why
    if (!is_mesh_name(name) || name.starts_with('.') || entry->is_directory(unknown)) continue;
    if (entry->is_fifo(unknown))
      throw InputError(entry->path().string(), 0, "expected a file, found a named pipe, whose writer may never come");
    names.push_back(name);
  }
  if (fault) throw InputError(folder, 0, "expected a readable folder, found '" + fault.message() + "'");
  std::sort(names.begin(), names.end(), natural_less);
  for (std::string& name : names) name = folder + (folder.ends_with('/') ? "" : "/") + name;
  return names;
}

Body union_of(const std::vector<Body>& pieces) {
  MeshFaces faces;
  std::uint32_t before = 0;  // points of the pieces before
  Pieces points;
  for (const Body& piece : pieces) {
    if (piece.faces) add_faces(*piece.faces, piece.points.size(), before, faces);
    before += static_cast<std::uint32_t>(piece.points.size());
    points.push_back(piece.points.exact());
  }
  Body body = union_of(std::move(points));
  body.faces = faces_of(std::move(faces));
  body.dimension = pieces.front().dimension;
  return body;
}

Body union_of(Pieces pieces) {
  Body body;
  body.pieces = std::make_shared<const Pieces>(std::move(pieces));
  return body;
}

Body read_union(const std::string& path, Decimals decimals, const PieceFilter& stays) {
  std::vector<Body> meshes;
  ScenePieces all = pieces_in_files(path, decimals);
  FileFacts facts{{}, std::move(all.notes)};
  std::size_t number = 0;
  for (NamedPiece& piece : all.pieces) {
    if (stays && !stays(piece, number++)) continue;
    if (piece.mesh.shape)
      throw InputError(
          path, 0,
          "expected polygons as pieces, found a circle: unions with radii have another depth than their cores");
    if (!meshes.empty() && meshes.front().dimension != piece.mesh.dimension)
      throw InputError(path, 0, "expected pieces that are all of the plane or all of space, found both");
    meshes.push_back(std::move(piece.mesh));
    facts.names.push_back(std::move(piece.name));
  }
  if (meshes.empty()) throw InputError(path, 0, "expected at least one piece that is not flat, found none");
  Body body = union_of(meshes);
  keep(std::move(facts), body);
  return body;
}

bool is_mesh_name(const std::string& name) {
  constexpr std::string_view meshes[] = {"off", "obj", "ply", "stl", "gltf", "glb", "dae", "3mf"};
  return std::ranges::find(meshes, extension(name)) != std::end(meshes);
}

MeshPath mesh_path(const std::string& path) {
  const auto is_there = [](const std::string& file) {
    std::error_code unknown;
    return file.find('\0') == std::string::npos && std::filesystem::exists(file, unknown);
  };
  if (!is_there(path))
    for (std::size_t at = path.find('#'); at != std::string::npos; at = path.find('#', at + 1))
      if (is_there(path.substr(0, at))) return {path.substr(0, at), path.substr(at + 1)};
  return {path, {}};
}

Body one_mesh(ScenePieces file) {
  std::vector<std::string> notes = all_notes(file);
  Body body;
  if (file.pieces.size() == 1) {
    body = std::move(file.pieces.front().mesh);
  } else {
    CollectedPoints points;
    MeshFaces faces;
    for (const NamedPiece& piece : file.pieces) {
      add_faces(*piece.mesh.faces, piece.mesh.points.size(), static_cast<std::uint32_t>(points.size()), faces);
      for (const std::array<double, 3>& p : piece.mesh.points.binary64()) points.add({p[0], p[1], p[2]});
      if (!piece.mesh.points.in_binary64())
        for (const Point& p : piece.mesh.points.exact()) points.add({p.x, p.y, p.z});
    }
    body = mesh_body(std::move(points), std::move(faces));
    notes.push_back("its " + std::to_string(file.pieces.size()) +
                    " meshes are taken as one; FILE#NAME is one of them, and with --pieces each is a convex piece");
  }
  keep({{}, std::move(notes)}, body);
  return body;
}

std::vector<std::string> file_notes(const Body& body) {
  const std::shared_ptr<const MeshFaces>& faces = body.solid ? body.solid->mesh_faces : body.faces;
  const auto* const facts = faces ? std::get_deleter<FileFacts>(faces) : nullptr;
  return facts ? facts->notes : std::vector<std::string>{};
}

std::string piece_name(const Body& body, std::size_t piece) {
  const auto* const facts = body.faces ? std::get_deleter<FileFacts>(body.faces) : nullptr;
  return facts ? facts->names.at(piece) : "";
}

}  // namespace fathom::files

namespace fathom {

Pieces parse_pieces(std::string_view text, const std::string& name, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  return files::points_of_pieces(files::parse_obj_pieces(text, name, decimals));
}

Pieces read_pieces(const std::string& path, Decimals decimals) {
  return files::points_of_pieces(files::pieces_in_files(path, decimals).pieces);
}

Body read_mesh(const std::string& path, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  if (files::mesh_path(path).piece) return files::one_mesh(files::pieces_of_path(path, decimals));
  const std::string bytes = files::read_file(path), folder = files::folder_of(path);
  const std::optional<MeshFormat> format = files::mesh_format(bytes, path);
  if (bytes.empty() || !format || !files::is_scene(*format)) return parse_mesh(bytes, path, decimals);
  return files::one_mesh(files::parse_scene(bytes, path, *format, &folder));
}

}  // namespace fathom
