// SPDX-License-Identifier: GPL-3.0-or-later
// OFF as in Geomview's manual, ASCII, three coordinates: a header, the counts, one line per vertex, one per face.
// Vertex lines may carry more columns (normal, colour, texture: NOFF, COFF, STOFF and plain OFF in the wild): not read.
#include <utility>

#include "reference/files/mesh_formats.hpp"

namespace fathom::files {
namespace {

// "ST", "C" and "N" in front say which columns follow x y z. "4" and "n" change the meaning of the coordinates themselves.
bool is_off_header(std::string_view token) {
  if (token.starts_with("ST")) token.remove_prefix(2);
  if (token.starts_with("C")) token.remove_prefix(1);
  if (token.starts_with("N")) token.remove_prefix(1);
  return token == "OFF";
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

}  // namespace

Body parse_off(std::string_view text, const std::string& name, Decimals decimals) {
  TextScanner scanner(text, name, {.comment = '#'});
  if (!scanner.next_line()) scanner.fail_at_end("the header 'OFF'");
  const std::string_view header = scanner.next_token();
  if (!is_off_header(header)) scanner.fail("the header 'OFF' (or COFF, NOFF, STOFF)", header);
  if (scanner.rest_of_line() == "BINARY") scanner.fail("text", "BINARY");
  if (scanner.rest_of_line().empty() && !scanner.next_line()) scanner.fail_at_end("the numbers of vertices and faces");
  const std::uint64_t vertices = scanner.count("the number of vertices");
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
  if (scanner.next_line()) scanner.fail("the end of the file after " + std::to_string(faces) + " faces", scanner.rest_of_line());
  return mesh_body(std::move(points), std::move(read));
}

}  // namespace fathom::files
