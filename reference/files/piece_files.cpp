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

#include "kernels/float_environment.hpp"
#include "kernels/number/parse.hpp"
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

bool is_mesh_name(const std::string& name) {
  const std::string kind = extension(name);
  return kind == "off" || kind == "obj" || kind == "ply" || kind == "stl";
}

Pieces points_of_pieces(const std::vector<NamedPiece>& pieces) {
  Pieces result;
  for (const NamedPiece& piece : pieces) result.push_back(piece.mesh.points.exact());
  return result;
}

std::vector<NamedPiece> pieces_in_files(const std::string& path, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  std::vector<NamedPiece> pieces;
  const bool in_folder = is_folder(path);
  for (const std::string& file : in_folder ? piece_files(path) : std::vector{path}) {
    const std::string bytes = read_file(file);
    const std::size_t before = pieces.size();
    if (mesh_format(bytes, file) == MeshFormat::obj)
      std::ranges::move(parse_obj_pieces(bytes, file, decimals), std::back_inserter(pieces));
    else pieces.push_back({parse_mesh(bytes, file, decimals), ""});
    for (std::size_t i = before; in_folder && i < pieces.size(); ++i)
      if (pieces[i].name.empty()) pieces[i].name = std::filesystem::path(file).filename().string();
  }
  if (pieces.empty())
    throw InputError(path, 0,
                     "expected a folder with mesh files (.off, .obj, .ply, .stl), the pieces, found none there");
  return pieces;
}

/// Deletes the faces of a union, which all its copies share, wherever they were moved to; and holds
/// what its pieces are called.
struct PieceNames {
  std::vector<std::string> names;
  void operator()(const MeshFaces* faces) const { delete faces; }
};

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
  return body;
}

Body union_of(Pieces pieces) {
  Body body;
  body.pieces = std::make_shared<const Pieces>(std::move(pieces));
  return body;
}

Body read_union(const std::string& path, Decimals decimals) {
  std::vector<Body> meshes;
  PieceNames called;
  for (NamedPiece& piece : pieces_in_files(path, decimals)) {
    meshes.push_back(std::move(piece.mesh));
    called.names.push_back(std::move(piece.name));
  }
  Body body = union_of(meshes);
  if (body.faces) body.faces = std::shared_ptr<const MeshFaces>(new MeshFaces(*body.faces), std::move(called));
  return body;
}

std::string piece_name(const Body& body, std::size_t piece) {
  const auto* const called = body.faces ? std::get_deleter<PieceNames>(body.faces) : nullptr;
  return called ? called->names.at(piece) : "";
}

}  // namespace fathom::files

namespace fathom {

Pieces parse_pieces(std::string_view text, const std::string& name, Decimals decimals) {
  const kernels::DefaultFloatEnvironment environment;
  return files::points_of_pieces(files::parse_obj_pieces(text, name, decimals));
}

Pieces read_pieces(const std::string& path, Decimals decimals) {
  return files::points_of_pieces(files::pieces_in_files(path, decimals));
}

}  // namespace fathom
