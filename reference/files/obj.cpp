// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: lines "v x y z" and "f i/j/k ...", for pieces "o" and "g" too; skips every other kind of line. A '#' starts a comment, but
// in the names of objects and groups, which run to the end of their line.
#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

// The vertex number that opens a corner "i", "i/j", "i//k" or "i/j/k". False: no such corner.
bool parse_corner(std::string_view token, std::int64_t& index) {
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, index);
  if (error != std::errc() || index == 0) return false;
  return stop == end || (*stop == '/' && std::string_view(stop, end).find_first_not_of("/-0123456789") == std::string_view::npos);
}

// Faces may come before the vertices that they name: the highest index is compared with the count at the end.
struct HighestIndex {
  std::uint64_t index = 0;
  std::size_t line = 0;
};

void read_face(TextScanner& scanner, std::uint64_t vertices_so_far, HighestIndex& highest, MeshFaces& faces) {
  std::string_view token = scanner.next_token();
  if (token.empty()) scanner.fail("the corners of a face", token);
  for (; !token.empty(); token = scanner.next_token()) {
    std::int64_t index = 0;
    if (!parse_corner(token, index)) scanner.fail("a vertex index such as 3, -1, 3/1 or 3//2", token);
    if (index < 0) {
      const std::uint64_t back = 0 - static_cast<std::uint64_t>(index);
      if (back > vertices_so_far) scanner.fail("a vertex index of at least -" + std::to_string(vertices_so_far), token);
    } else if (static_cast<std::uint64_t>(index) > highest.index) {
      highest = {static_cast<std::uint64_t>(index), scanner.line()};
    }
    faces.corners.push_back(static_cast<std::uint32_t>(index < 0 ? static_cast<std::int64_t>(vertices_so_far) + index : index - 1));
  }
  faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
}

void require_vertices(const TextScanner& scanner, const std::string& name, std::size_t points, const HighestIndex& highest) {
  if (points == 0) scanner.fail_at_end("at least one vertex 'v x y z'");
  if (highest.index <= points) return;
  throw InputError(name, highest.line,
                   "expected a vertex index of at most " + std::to_string(points) + ", found '" + std::to_string(highest.index) + "'");
}

/// Which piece the faces after a line 'o' or 'g' belong to. Each line 'o' begins an object, also of a name that was there; in it, groups of
/// one name are one, and those without a name are new ones.
class Groups {
 public:
  void object() {
    ++object_;
    group_.clear();
  }
  void group(std::string_view name) { group_ = name.empty() ? "\n" + std::to_string(++unnamed_) : std::string(name); }
  std::size_t piece() { return pieces_.try_emplace({object_, group_}, pieces_.size()).first->second; }

 private:
  std::size_t object_ = 0, unnamed_ = 0;
  std::string group_;
  std::map<std::pair<std::size_t, std::string>, std::size_t> pieces_;
};

/// The mesh of these faces alone: their corners, in the order of their numbers.
Body piece_of(const std::vector<Point>& points, MeshFaces faces) {
  std::vector<std::uint32_t> used = faces.corners;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::uint32_t& corner : faces.corners)
    corner = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
  std::vector<Point> corners;
  for (const std::uint32_t i : used) corners.push_back(points[i]);
  Body piece{std::move(corners)};
  piece.faces = faces_of(std::move(faces));
  return piece;
}

}  // namespace

Body parse_obj(std::string_view text, const std::string& name, Decimals decimals) {
  TextScanner scanner(text, name, {.comment = '#', .continuation = true});
  CollectedPoints points;
  HighestIndex highest;
  MeshFaces faces;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.next_token();
    if (keyword == "v") read_point(scanner, decimals, points);
    if (keyword == "f") read_face(scanner, points.size(), highest, faces);
  }
  require_vertices(scanner, name, points.size(), highest);
  return mesh_body(std::move(points), std::move(faces));
}

std::vector<Body> parse_obj_pieces(std::string_view text, const std::string& name, Decimals decimals) {
  TextScanner scanner(text, name, {.comment = '#', .continuation = true});
  std::vector<Point> points;
  HighestIndex highest;
  Groups groups;
  std::vector<MeshFaces> faces;  // of each piece
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.next_token();
    if (keyword == "o") groups.object();
    if (keyword == "g") groups.group(scanner.name_to_end_of_line());
    if (keyword == "v") {
      Point& p = points.emplace_back();
      for (mpq_class* c : {&p.x, &p.y, &p.z}) *c = exact(read_coordinate(scanner, decimals));
    }
    if (keyword != "f") continue;
    const std::size_t piece = groups.piece();
    if (piece == faces.size()) faces.emplace_back();
    read_face(scanner, points.size(), highest, faces[piece]);
  }
  require_vertices(scanner, name, points.size(), highest);
  if (faces.empty()) scanner.fail_at_end("at least one face 'f i j k': a piece is what the faces of a group have as corners");
  std::vector<Body> pieces;
  for (MeshFaces& of_piece : faces) pieces.push_back(piece_of(points, std::move(of_piece)));
  return pieces;
}

}  // namespace fathom::files
