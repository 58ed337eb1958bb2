// SPDX-License-Identifier: GPL-3.0-or-later
// What a solid says of itself: its volume, its pieces for others, its notes.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "fathom/numbers.hpp"
#include "fathom/solid.hpp"
#include "kernels/messages.hpp"
#include "kernels/vector.hpp"

namespace fathom {
namespace {

/// The pieces that are not listed before: equal ones follow one another.
std::vector<const Solid::Piece*> distinct_pieces(const Solid& solid) {
  std::vector<const Solid::Piece*> pieces;
  for (const Solid::Piece& piece : solid.pieces)
    if (pieces.empty() || pieces.back()->facets != piece.facets) pieces.push_back(&piece);
  return pieces;
}

std::vector<std::uint32_t> corners_of(const Solid::Piece& piece) {
  std::vector<std::uint32_t> corners;
  for (const std::vector<std::uint32_t>& facet : piece.facets)
    corners.insert(corners.end(), facet.begin(), facet.end());
  std::ranges::sort(corners);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

mpq_class det_at(const Solid& solid, std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  const Point& origin = solid.points.front();
  return dot(cross(solid.points[p] - origin, solid.points[q] - origin), solid.points[r] - origin);
}

}  // namespace

mpq_class volume(const Solid& solid) {
  mpq_class sum;
  if (!solid.overlaps) {
    for (const auto& [p, q, r] : solid.triangles) sum += det_at(solid, p, q, r);
    return sum / 6;
  }
  for (const Solid::Piece* piece : distinct_pieces(solid))
    for (const std::vector<std::uint32_t>& facet : piece->facets)
      for (std::size_t i = 1; i + 1 < facet.size(); ++i) sum += det_at(solid, facet[0], facet[i], facet[i + 1]);
  return sum / 6;
}

Pieces pieces_of(const Solid& solid) {
  Pieces pieces;
  for (const Solid::Piece* piece : distinct_pieces(solid)) {
    std::vector<Point>& points = pieces.emplace_back();
    for (const std::uint32_t i : corners_of(*piece)) points.push_back(solid.points[i]);
  }
  return pieces;
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
  for (const Solid::Piece* piece : distinct_pieces(solid)) {
    text += fmt::format("g piece_{}\n", ++number);
    for (const std::vector<std::uint32_t>& facet : piece->facets) {
      text += 'f';
      for (const std::uint32_t i : facet) text += fmt::format(" {}", i + 1);
      text += '\n';
    }
  }
  return text;
}

}  // namespace fathom
