// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/unions/separating.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/filters/support.hpp"

namespace fathom::unions {
namespace {

// Bounds on errors, in any rounding mode.             [proofs/unions.md, "Pairs on demand"]
constexpr double of_margin = 0x1p-46;      // of a box's margin, times 1 + |p|
constexpr double of_separation = 0x1p-43;  // of <u, p> - h(u), times |u| (1 + |p|)
constexpr double of_gap = 0x1p-36;         // of d |u|, relative
constexpr int most_turns = 24;

double largest(const Vec3<double>& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
double length(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }

struct Farthest {
  Vec3<double> at{};
  double height = -std::numeric_limits<double>::infinity();
};

// The image farthest in direction u.
Farthest farthest(std::span<const PlacedPiece> pieces, const Vec3<double>& u) {
  Farthest most;
  for (const PlacedPiece& piece : pieces) {
    const kernels::Images images = piece.cloud.images();
    Farthest found;
    for (std::size_t i = 0; i < images.size(); ++i) {
      const Vec3<double> at{images.x[i], images.y[i], images.z[i]};
      if (const double height = dot(u, at); height > found.height) found = {at, height};
    }
    if (piece.scale * found.height > most.height) most = {piece.scale * found.at, piece.scale * found.height};
  }
  return most;
}

struct Above {
  Vec3<double> corner;   // of all P_ij, the farthest in the direction
  double height, error;  // <u, p> - h(u) - d |u|, and a bound on its error
};

Above above(const PairBlock& block, const Vec3<double>& at, double d, const Vec3<double>& u) {
  const Farthest of_a = farthest(block.a, -u), of_b = farthest(block.b, u);
  const double away = d == 0 ? 0 : d * length(u);
  return {of_b.at - of_a.at, dot(u, at) - (of_a.height + of_b.height) - away,
          of_separation * largest(u) * (1 + largest(at)) + of_gap * away};
}

constexpr double most_size = 0x1p40;  // of p, for which bounds are useful

}  // namespace

double margin_error(const Vec3<double>& at) { return of_margin * (1 + largest(at)); }

std::optional<bool> keeps_apart(const PairBlock& block, const Vec3<double>& at, double d, const Vec3<double>& u) {
  if (!(largest(at) < most_size && d < most_size)) return std::nullopt;
  const Above found = above(block, at, d, u);
  if (found.height > found.error) return true;
  if (found.height < -found.error) return false;
  return std::nullopt;
}

bool surely_apart(const PairBlock& block, const Vec3<double>& at, double d, Vec3<double>& u) {
  if (!(largest(at) < most_size && d < most_size)) return false;
  if (largest(u) == 0) {
    const PlacedPiece &a = block.a.front(), &b = block.b.front();
    const kernels::Images of_a = a.cloud.images(), of_b = b.cloud.images();
    u = at - (b.scale * Vec3<double>{of_b.x[0], of_b.y[0], of_b.z[0]} -
              a.scale * Vec3<double>{of_a.x[0], of_a.y[0], of_a.z[0]});
    const double size = largest(u);
    if (!(size > 0x1p-40)) return false;
    u = (1 / size) * u;
  }
  for (int turn = 0; turn < most_turns; ++turn) {
    const Above found = above(block, at, d, u);
    if (found.height > found.error) return true;
    Vec3<double> away = at - found.corner;
    if (d > 0) away = away - (d / length(u)) * u;
    const double square = dot(away, away);
    if (!(square > 0x1p-100)) return false;
    u = u - (2 * dot(u, away) / square) * away;
  }
  return false;
}

}  // namespace fathom::unions
