// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a solid as text: format 5.                [verify/check/FORMAT.md, section 14]
#include "fathom/solid.hpp"
#include "kernels/vector.hpp"
#include "reference/certificate/certificate.hpp"

namespace fathom::certificate {

// Points that nothing uses are left out.
std::vector<std::uint32_t> write_solid(Writer& out, std::string_view name, const Solid& solid,
                                       std::vector<std::size_t>& counts) {
  std::vector<std::uint32_t> numbers(solid.points.size());
  for (const auto& triangle : solid.triangles)
    for (const std::uint32_t k : triangle) numbers.at(k) = 1;
  for (const Solid::Piece& piece : solid.pieces)
    for (const auto& facet : piece.facets)
      for (const std::uint32_t k : facet) numbers.at(k) = 1;
  std::vector<Point> points;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (numbers[k] == 0) continue;
    numbers[k] = static_cast<std::uint32_t>(points.size());
    points.push_back(solid.points[k]);
  }
  const auto write_indices = [&](const auto& indices) {
    for (const std::uint32_t k : indices) out.word(std::size_t{numbers[k]});
    out.end();
  };
  write_points(out, name, std::span<const Point>(points));
  out.word("mesh").word(solid.triangles.size()).end();
  for (const auto& triangle : solid.triangles) write_indices(triangle);
  out.word("pieces").word(solid.pieces.size()).end();
  counts.insert(counts.end(), {points.size(), solid.triangles.size(), solid.pieces.size()});
  for (const Solid::Piece& piece : solid.pieces) {
    out.word("piece").word(piece.facets.size()).end();
    counts.push_back(piece.facets.size());
    for (const auto& facet : piece.facets) {
      out.word(facet.size());
      write_indices(facet);
    }
  }
  return numbers;
}

}  // namespace fathom::certificate

namespace fathom {

std::string certificate_text(const Solid& solid, std::string_view id) {
  certificate::Writer out(20000);
  std::vector<std::size_t> counts;
  certificate::write_header(out, 5, id);
  certificate::write_solid(out, "solid_a", solid, counts);
  out.word("claim").word("solid").end();
  certificate::write_end(out, counts);
  return out.take();
}

}  // namespace fathom
