// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <utility>

#include "verify/families/solids.hpp"

namespace fathom::families {

namespace {

__extension__ typedef __int128 Wide;
constexpr unsigned fraction = 60;  // fixed point, 60 bits after the point
constexpr std::int64_t one = std::int64_t{1} << fraction;
constexpr std::int64_t half_pi = 1811004864519280711;  // pi / 2 * 2^60, rounded

std::int64_t product(std::int64_t a, std::int64_t b) { return static_cast<std::int64_t>((Wide{a} * b) >> fraction); }

/// cos and sin of an angle in [0, pi/4], in fixed point: Taylor series, whose terms fall below 2^-60 before the 20th.
std::pair<std::int64_t, std::int64_t> taylor(std::int64_t angle) {
  std::int64_t cosine = one, sine = 0, term = one;
  for (int power = 1; power < 22; ++power) {
    term = product(term, angle) / power;
    std::int64_t& sum = power % 2 ? sine : cosine;
    sum += power % 4 < 2 ? term : -term;
  }
  return {cosine, sine};
}

std::int64_t rounded(std::int64_t value, unsigned bits) {
  const unsigned shift = fraction - bits;
  return (value + (std::int64_t{1} << (shift - 1))) >> shift;
}

}  // namespace

CirclePoint circle_point(std::uint64_t k, std::uint64_t n, unsigned bits) {
  const std::uint64_t quadrant = 4 * k / n, rest = 4 * k % n;
  const bool steep = 2 * rest > n;  // beyond pi/4: swap, so that the octants mirror each other
  const std::uint64_t share = steep ? n - rest : rest;
  auto [cosine, sine] = taylor(static_cast<std::int64_t>(Wide{half_pi} * share / n));
  if (steep) std::swap(cosine, sine);
  const std::int64_t c = rounded(cosine, bits), s = rounded(sine, bits);
  switch (quadrant) {
    case 0: return {c, s};
    case 1: return {-s, c};
    case 2: return {-c, -s};
    default: return {s, -c};
  }
}

unsigned circle_bits(std::uint64_t n) {
  const unsigned needed = 12 + 2 * static_cast<unsigned>(std::bit_width(n - 1));  // steps of a polygon turn by about (2 pi / n)^2
  return needed < 20 ? 20 : needed > 52 ? 52 : needed;
}

std::vector<CirclePoint> regular_polygon(std::uint64_t n, unsigned phase) {
  std::vector<CirclePoint> corners;
  corners.reserve(n);
  for (std::uint64_t k = 0; k < n; ++k) corners.push_back(circle_point(4 * k + phase, 4 * n, circle_bits(n)));
  return corners;
}

}  // namespace fathom::families
