// SPDX-License-Identifier: GPL-3.0-or-later
// What a solid says of itself: its volume, its pieces for others, its notes.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>

#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "kernels/messages.hpp"
#include "kernels/vector.hpp"
#include "reference/solids/listed_pieces.hpp"

namespace fathom::solids {

std::vector<std::uint32_t> corners_of(const Solid::Piece& piece) {
  std::vector<std::uint32_t> corners;
  for (const std::vector<std::uint32_t>& facet : piece.facets)
    corners.insert(corners.end(), facet.begin(), facet.end());
  std::ranges::sort(corners);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

bool is_repeated(const Solid& solid, std::size_t i) {
  return i > 0 && solid.pieces[i].facets == solid.pieces[i - 1].facets;
}

}  // namespace fathom::solids

namespace fathom {
namespace {

using solids::is_repeated;

mpq_class det_at(const Solid& solid, std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  const Point& origin = solid.points.front();
  return dot(cross(solid.points[p] - origin, solid.points[q] - origin), solid.points[r] - origin);
}

}  // namespace

std::size_t given_points(const Solid& solid) {
  std::uint32_t count = 0;
  for (const auto& triangle : solid.triangles) count = std::max(count, *std::ranges::max_element(triangle) + 1);
  return count;
}

// What the mesh goes around several times is taken away: of the rest, numbers are short.
mpq_class volume(const Solid& solid) {
  mpq_class sum;
  for (const auto& [p, q, r] : solid.triangles) sum += det_at(solid, p, q, r);
  for (std::size_t k = 0; k < solid.pieces.size(); ++k) {
    if (!is_repeated(solid, k)) continue;
    for (const std::vector<std::uint32_t>& facet : solid.pieces[k].facets)
      for (std::size_t i = 1; i + 1 < facet.size(); ++i) sum -= det_at(solid, facet[0], facet[i], facet[i + 1]);
  }
  return sum / 6;
}

Pieces pieces_of(const Solid& solid) {
  Pieces pieces;
  for (std::size_t k = 0; k < solid.pieces.size(); ++k) {
    if (is_repeated(solid, k)) continue;
    std::vector<Point>& points = pieces.emplace_back();
    for (const std::uint32_t i : solids::corners_of(solid.pieces[k])) points.push_back(solid.points[i]);
  }
  return pieces;
}

Body solid_body(const Body& mesh) {
  Body body;
  body.solid = std::make_shared<const Solid>(solid_of(mesh));
  body.pieces = std::make_shared<const Pieces>(pieces_of(*body.solid));
  return body;
}

std::vector<std::string> notes(const Solid& solid) {
  std::vector<std::string> found;
  if (solid.bent_faces > 0)
    found.push_back(fmt::format("{} not flat: cut from the first corner{}",
                                kernels::counted(solid.bent_faces, "face of the mesh is", "faces of the mesh are"),
                                solid.bent_faces == 1 ? "" : " of each"));
  if (solid.turned) found.emplace_back("the faces of the mesh look inwards: turned over");
  if (solid.overlaps) found.emplace_back("the mesh overlaps itself: what it goes around more than once counts once");
  return found;
}

std::string pieces_obj(const Solid& solid) {
  std::string text = "# convex pieces, one a group; coordinates are exact\n";
  for (const Point& p : solid.points)
    text += fmt::format("v {} {} {}\n", exact_text(p.x), exact_text(p.y), exact_text(p.z));
  std::size_t number = 0;
  for (std::size_t k = 0; k < solid.pieces.size(); ++k) {
    if (is_repeated(solid, k)) continue;
    text += fmt::format("g piece_{}\n", number++);
    for (const std::vector<std::uint32_t>& facet : solid.pieces[k].facets) {
      text += 'f';
      for (const std::uint32_t i : facet) text += fmt::format(" {}", i + 1);
      text += '\n';
    }
  }
  return text;
}

}  // namespace fathom
