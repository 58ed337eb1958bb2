// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ: lines "v x y z" and "f i/j/k ..."; skips every other kind of line.
#include <charconv>
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
  if (points.empty()) scanner.fail_at_end("at least one vertex 'v x y z'");
  if (highest.index > points.size()) {
    throw InputError(
        name, highest.line,
        "expected a vertex index of at most " + std::to_string(points.size()) + ", found '" + std::to_string(highest.index) + "'");
  }
  return mesh_body(std::move(points), std::move(faces));
}

}  // namespace fathom::files
