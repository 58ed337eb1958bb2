// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of two unions, put on one lattice.
#include "reference/unions/placed_pieces.hpp"

#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernels/number/rational.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::unions {
namespace {

void require_points(const Pieces& pieces, const std::string& body) {
  if (pieces.empty()) throw std::invalid_argument("body " + body + " has no pieces");
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].empty()) throw std::invalid_argument("piece " + std::to_string(i) + " of " + body + " has no points");
}

std::vector<kernels::PointCloud> parted(const kernels::PointCloud& whole, const Pieces& pieces,
                                        const std::string& body) {
  std::vector<kernels::PointCloud> clouds;
  auto from = whole.points().begin();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto to = std::next(from, static_cast<std::ptrdiff_t>(pieces[i].size()));
    std::vector<Vector> points(from, to);
    if (polytope::affine_rank(points) < 3)
      throw std::invalid_argument("piece " + std::to_string(i) + " of " + body +
                                  " is flat: the pieces of a union need interiors");
    clouds.emplace_back(std::move(points), whole.exponent());
    from = to;
  }
  return clouds;
}

}  // namespace

PlacedPieces place_pieces(const Pieces& a, const Pieces& b) {
  require_points(a, "A");
  require_points(b, "B");
  PlacedPieces placed;
  placed.whole = polytope::place(polytope::joined(a), polytope::joined(b));
  placed.a = parted(placed.whole.a, a, "A");
  placed.b = parted(placed.whole.b, b, "B");
  return placed;
}

polytope::PlacedPair PlacedPieces::pair(std::uint32_t i, std::uint32_t j) const {
  return {whole.denominator, whole.origin, a[i], b[j]};
}

Point PlacedPieces::translation(const kernels::RationalPoint& p) const {
  const mpz_class w = p.w * whole.denominator;
  return {kernels::ratio(p.v.x, w), kernels::ratio(p.v.y, w), kernels::ratio(p.v.z, w)};
}

kernels::RationalPoint PlacedPieces::point(const Point& t) const {
  const mpz_class w = lcm(lcm(t.x.get_den(), t.y.get_den()), t.z.get_den());
  const auto over_w = [&](const mpq_class& x) {
    return mpz_class(x.get_num() * (w / x.get_den()) * whole.denominator);
  };
  return kernels::rational_point({over_w(t.x), over_w(t.y), over_w(t.z)}, w, exponent());
}

mpq_class PlacedPieces::squared(const mpz_class& numerator, const mpz_class& denominator) const {
  return kernels::ratio(numerator, denominator * whole.denominator * whole.denominator);
}

}  // namespace fathom::unions
