// SPDX-License-Identifier: GPL-3.0-or-later
// Directions that keep a point apart from the P_ij of many pairs of pieces at once, by images: what
// they say is certain.                      [proofs/unions.md, "Pairs on demand" and "Blocks"]
#pragma once

#include <optional>
#include <span>

#include "kernels/vector.hpp"
#include "reference/unions/pieces.hpp"

namespace fathom::unions {

/// All pairs of a piece of A and a piece of B. Their support function h(u) is the largest h_ij(u).
struct PairBlock {
  std::span<const PlacedPiece> a, b;
};

/// A bound on the error of a margin of boxes, for a point with this image, in any rounding mode.
double margin_error(const Vec3<double>& at);

/// Whether <u, p> - h(u) >= d |u|, for the image `at` of p and that of a direction, which may be
/// off by a rounding in each component. `d`: in units of 2^exponent, an upper bound, within 2^-37
/// of itself from 2^-400 on. Returns nullopt where images leave it open.
std::optional<bool> keeps_apart(const PairBlock& block, const Vec3<double>& at, double d, const Vec3<double>& u);

/// Whether a direction u is found for which keeps_apart is true. `u` is the direction to begin
/// with, or O, and in the end the last that was tried: reflected in the way to the farthest point
/// until it points away from it.
bool surely_apart(const PairBlock& block, const Vec3<double>& at, double d, Vec3<double>& u);

}  // namespace fathom::unions
