// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a solid as text: format 5.                [verify/check/FORMAT.md, section 14]
#include "fathom/solid.hpp"
#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"

namespace fathom::certificate {
namespace {

/// The points that something uses, and their numbers among these.
struct UsedPoints {
  explicit UsedPoints(const Solid& solid) : numbers(solid.points.size()) {
    for (const auto& triangle : solid.triangles)
      for (const std::uint32_t k : triangle) numbers.at(k) = 1;
    for (const Solid::Piece& piece : solid.pieces)
      for (const auto& facet : piece.facets)
        for (const std::uint32_t k : facet) numbers.at(k) = 1;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (numbers[k] == 0) continue;
      numbers[k] = points.size();
      points.push_back(solid.points[k]);
    }
  }

  std::vector<std::size_t> numbers;
  std::vector<Point> points;
};

}  // namespace
}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(const Solid& solid, std::string_view id) {
  const certificate::UsedPoints used(solid);
  certificate::Writer out(20000);
  const auto write_indices = [&](const auto& indices) {
    for (const std::uint32_t k : indices) out.word(used.numbers[k]);
    out.end();
  };
  out.word("fathom-certificate 5").end();
  if (!id.empty()) out.word("id").word(certificate::escaped(id)).end();
  certificate::write_points(out, "solid_a", std::span<const Point>(used.points));
  out.word("mesh").word(solid.triangles.size()).end();
  for (const auto& triangle : solid.triangles) write_indices(triangle);
  out.word("pieces").word(solid.pieces.size()).end();
  for (const Solid::Piece& piece : solid.pieces) {
    out.word("piece").word(piece.facets.size()).end();
    for (const auto& facet : piece.facets) {
      out.word(facet.size());
      write_indices(facet);
    }
  }
  out.word("claim").word("solid").end();
  out.word("end").word(used.points.size()).word(solid.triangles.size()).word(solid.pieces.size());
  for (const Solid::Piece& piece : solid.pieces) out.word(piece.facets.size());
  out.end();
  return out.take();
}

}  // namespace fathom
