// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh formats that are lines of numbers: OFF, OBJ, and plain points.
#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include "kernels/messages.hpp"
#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

// ---- OFF ----

// OFF as in Geomview's manual, ASCII, three coordinates: a header, the counts, one line per vertex,
// one per face. Vertex lines may carry more columns (normal, colour, texture: NOFF, COFF, STOFF and
// plain OFF in the wild): not read.

// "ST", "C" and "N" in front say which columns follow x y z. "4" and "n" change the meaning of the
// coordinates themselves. Returns what follows, which is nothing, or the first of the counts:
// "OFF8 6 12", as in ModelNet. Returns nullopt if it is no header.
std::optional<std::string_view> after_off(std::string_view token) {
  if (token.starts_with("ST")) token.remove_prefix(2);
  if (token.starts_with("C")) token.remove_prefix(1);
  if (token.starts_with("N")) token.remove_prefix(1);
  std::uint64_t count = 0;
  if (!token.starts_with("OFF") && token != "off") return std::nullopt;
  token.remove_prefix(3);
  return token.empty() || parse_count(token, count) ? std::optional(token) : std::nullopt;
}

void read_face(TextScanner& scanner, std::uint64_t vertices, MeshFaces& faces) {
  const std::uint64_t corners = scanner.count("the number of corners of a face");
  for (std::uint64_t i = 0; i < corners; ++i) {
    const std::string_view token = scanner.next_token();
    std::uint64_t index = 0;
    const bool good = parse_count(token, index) && index < vertices;
    if (!good) scanner.fail("a vertex index below " + std::to_string(vertices), token);
    faces.corners.push_back(static_cast<std::uint32_t>(index));
  }
  faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
}

std::string ordinal(const char* what, std::uint64_t i, std::uint64_t count) {
  return std::string(what) + " " + std::to_string(i + 1) + " of " + std::to_string(count);
}

// ---- Wavefront OBJ ----

// Lines "v x y z" and "f i/j/k ...", for pieces "o" and "g" too; skips every other kind of line. A
// '#' starts a comment, but in the names of objects and groups, which run to the end of their line.

// The vertex number that opens a corner "i", "i/j", "i//k" or "i/j/k". False: no such corner.
bool parse_corner(std::string_view token, std::int64_t& index) {
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, index);
  if (error != std::errc() || index == 0) return false;
  return stop == end ||
         (*stop == '/' && std::string_view(stop, end).find_first_not_of("/-0123456789") == std::string_view::npos);
}

// Faces may come before the vertices that they name: the highest index is compared with the count
// at the end.
struct HighestIndex {
  std::uint64_t index = 0;
  std::size_t line = 0;
  std::string group = "";  ///< its name, if it has one
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
    faces.corners.push_back(
        static_cast<std::uint32_t>(index < 0 ? static_cast<std::int64_t>(vertices_so_far) + index : index - 1));
  }
  faces.ends.push_back(static_cast<std::uint32_t>(faces.corners.size()));
}

void require_vertices(const TextScanner& scanner, const std::string& name, std::size_t points,
                      const HighestIndex& highest) {
  if (points == 0) scanner.fail_at_end("at least one vertex 'v x y z'");
  if (highest.index <= points) return;
  throw InputError(name, highest.line,
                   "expected a vertex index of at most " + std::to_string(points) + ", found '" +
                       std::to_string(highest.index) + "'" +
                       (highest.group.empty() ? "" : " in the group " + kernels::shown(highest.group)));
}

/// Which piece the faces after a line 'o' or 'g' belong to. Each line 'o' begins an object, also of
/// a name that was there; in it, groups of one name are one, and those without a name are new ones.
class Groups {
 public:
  void object(std::string_view name) {
    ++object_;
    group_.clear();
    name_ = name;
  }
  void group(std::string_view name) {
    group_ = name.empty() ? "\n" + std::to_string(++unnamed_) : std::string(name);
    name_ = name;
  }
  std::size_t piece() { return pieces_.try_emplace({object_, group_}, pieces_.size()).first->second; }
  const std::string& name() const { return name_; }  ///< of the group, or of an object without any

 private:
  std::size_t object_ = 0, unnamed_ = 0;
  std::string group_, name_;
  std::map<std::pair<std::size_t, std::string>, std::size_t> pieces_;
};

/// The mesh of these faces alone: their corners, in the order of their numbers.
Body piece_of(const std::vector<Point>& points, MeshFaces faces) {
  std::vector<Point> corners;
  for (const std::uint32_t i : renumbered(faces.corners)) corners.push_back(points[i]);
  Body piece{std::move(corners)};
  piece.faces = faces_of(std::move(faces));
  return piece;
}

// ---- plain points ----

// One a line: x y z, or x,y,z; or x y, and the body is one of the plane. Skips further columns
// (normals, colours), if every line has as many.
// A first line with a single whole number announces how many points follow (as in .pts files), and
// must be right.

// A line with a comma is separated by commas alone: "1,5 2,5 3,5" (commas as decimal points) must
// not pass for numbers.
void split(TextScanner& scanner, std::vector<std::string_view>& columns) {
  columns.clear();
  std::string_view line = scanner.rest_of_line();
  if (line.find(',') == std::string_view::npos) {
    for (std::string_view token = scanner.next_token(); !token.empty(); token = scanner.next_token())
      columns.push_back(token);
    return;
  }
  for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    columns.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  columns.push_back(trimmed(line));
}

std::string number_of(std::size_t columns) { return std::to_string(columns) + (columns == 1 ? " column" : " columns"); }

}  // namespace

std::vector<std::uint32_t> renumbered(std::vector<std::uint32_t>& corners) {
  std::vector<std::uint32_t> used = corners;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::uint32_t& corner : corners)
    corner = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
  return used;
}

Body parse_off(std::string_view text, const std::string& name, Decimals decimals) {
  TextScanner scanner(text, name, {.comment = '#'});
  if (!scanner.next_line()) scanner.fail_at_end("the header 'OFF'");
  const std::string_view header = scanner.next_token();
  const std::optional<std::string_view> glued = after_off(header);
  if (!glued) scanner.fail("the header 'OFF' (or COFF, NOFF, STOFF)", header);
  if (scanner.rest_of_line() == "BINARY") scanner.fail("text", "BINARY");
  if (glued->empty() && scanner.rest_of_line().empty() && !scanner.next_line())
    scanner.fail_at_end("the numbers of vertices and faces");
  std::uint64_t vertices = 0;
  if (!parse_count(*glued, vertices)) vertices = scanner.count("the number of vertices");
  const std::uint64_t faces = scanner.count("the number of faces");
  if (vertices == 0) scanner.fail("at least one vertex", "0");

  CollectedPoints points;
  reserve_within(points, vertices, scanner.bytes_left(), 6);  // "0 0 0\n"
  for (std::uint64_t i = 0; i < vertices; ++i) {
    if (!scanner.next_line()) scanner.fail_at_end(ordinal("vertex", i, vertices));
    read_point(scanner, decimals, points);
  }
  MeshFaces read;
  reserve_within(read.ends, faces, scanner.bytes_left(), 2);  // "0\n"
  reserve_within(read.corners, 3 * faces, scanner.bytes_left(), 2);
  for (std::uint64_t i = 0; i < faces; ++i) {
    if (!scanner.next_line()) scanner.fail_at_end(ordinal("face", i, faces));
    read_face(scanner, vertices, read);
  }
  if (scanner.next_line())
    scanner.fail("the end of the file after " + std::to_string(faces) + " faces", scanner.rest_of_line());
  return mesh_body(std::move(points), std::move(read));
}

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

std::vector<NamedPiece> parse_obj_pieces(std::string_view text, const std::string& name, Decimals decimals) {
  TextScanner scanner(text, name, {.comment = '#', .continuation = true});
  std::vector<Point> points;
  HighestIndex highest;
  Groups groups;
  std::vector<MeshFaces> faces;  // of each piece
  std::vector<std::string> names;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.next_token();
    if (keyword == "o") groups.object(scanner.name_to_end_of_line());
    if (keyword == "g") groups.group(scanner.name_to_end_of_line());
    if (keyword == "v") {
      Point& p = points.emplace_back();
      for (mpq_class* c : {&p.x, &p.y, &p.z}) *c = exact(read_coordinate(scanner, decimals));
    }
    if (keyword != "f") continue;
    const std::size_t piece = groups.piece();
    if (piece == faces.size()) (faces.emplace_back(), names.push_back(groups.name()));
    const std::uint64_t before = highest.index;
    read_face(scanner, points.size(), highest, faces[piece]);
    if (highest.index > before) highest.group = names[piece];
  }
  require_vertices(scanner, name, points.size(), highest);
  if (faces.empty())
    scanner.fail_at_end("at least one face 'f i j k': a piece is what the faces of a group have as corners");
  std::vector<NamedPiece> pieces;
  for (std::size_t i = 0; i < faces.size(); ++i)
    pieces.push_back({piece_of(points, std::move(faces[i])), std::move(names[i])});
  return pieces;
}

Body parse_xyz(std::string_view text, const std::string& name, Decimals decimals) {
  TextScanner scanner(text, name, {.comment = '#'});
  CollectedPoints points;
  std::optional<std::uint64_t> announced;
  std::vector<std::string_view> columns;
  std::size_t width = 0;
  while (scanner.next_line()) {
    split(scanner, columns);
    std::uint64_t count = 0;
    if (width == 0 && !announced && columns.size() == 1 && parse_count(columns[0], count)) {
      announced = count;
      reserve_within(points, count, scanner.bytes_left(), 6);  // "0 0 0\n"
      continue;
    }
    const std::string expected =
        width ? number_of(width) + " as in the lines before" : "three numbers x y z, or two of the plane";
    if (columns.size() < 2 || (width && columns.size() != width)) {
      throw InputError(name, scanner.line(), "expected " + expected + ", found " + number_of(columns.size()));
    }
    width = columns.size();
    std::array<Coordinate, 3> point{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < std::min(width, point.size()); ++i)
      point[i] = parse_coordinate(columns[i], scanner, decimals);
    points.add(std::move(point));
  }
  if (points.empty()) scanner.fail_at_end("at least one point x y z");
  if (announced && *announced != points.size()) {
    scanner.fail("the number of points announced, " + std::to_string(*announced), std::to_string(points.size()));
  }
  Body body{points.take()};
  if (width == 2) body.dimension = 2;
  return body;
}

}  // namespace fathom::files
