// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <utility>

#include "reference/polytope/position.hpp"

namespace fathom::polytope {
namespace {

Vector scaled(const mpz_class& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }

/// Returns the foot of O on the affine hull of one to three affinely independent points, or nullopt unless all of its weights are positive.
std::optional<SimplexFoot> foot(const std::vector<SimplexCorner>& corners) {
  const Vector& p = corners[0].p;
  if (corners.size() == 1) return SimplexFoot{p, {1}, 1};
  const Vector e = corners[1].p - p;
  if (corners.size() == 2) {
    const mpz_class square = dot(e, e), w = -dot(p, e);
    if (w <= 0 || w >= square) return std::nullopt;
    return SimplexFoot{scaled(square, p) + scaled(w, e), {square - w, w}, square};
  }
  // In the plane of the three, every point is p + (<(x - p) x f, n> e + <e x (x - p), n> f) / <n, n>.
  const Vector f = corners[2].p - p, n = cross(e, f);
  const mpz_class square = dot(n, n), v = det(-p, f, n), w = det(e, -p, n);
  mpz_class u = square - v - w;
  if (u <= 0 || v <= 0 || w <= 0) return std::nullopt;
  return SimplexFoot{scaled(dot(n, p), n), {std::move(u), v, w}, square};
}

bool nearest_of(const SimplexFoot& z, const std::vector<SimplexCorner>& corners) {
  const mpz_class square = dot(z.point, z.point);
  return std::all_of(corners.begin(), corners.end(), [&](const SimplexCorner& c) { return z.denominator * dot(z.point, c.p) >= square; });
}

}  // namespace

std::optional<SimplexFoot> nearest_in_simplex(std::vector<SimplexCorner>& corners) {
  const unsigned last = 1U << (corners.size() - 1);
  for (unsigned subset = last; subset < 2 * last; ++subset) {
    if (std::popcount(subset) > 3) continue;
    std::vector<SimplexCorner> chosen;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (subset >> i & 1U) chosen.push_back(corners[i]);
    std::optional<SimplexFoot> z = foot(chosen);
    if (!z || !nearest_of(*z, corners)) continue;
    corners = std::move(chosen);
    return z;
  }
  return std::nullopt;
}

}  // namespace fathom::polytope
