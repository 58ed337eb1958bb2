// SPDX-License-Identifier: GPL-3.0-or-later
// Fans: bodies whose Gaussian diagram is a bundle of long arcs, nearly parallel; and pairs of fans across each other.
#pragma once

#include <cstdint>
#include <vector>

#include "verify/families/solids.hpp"

namespace fathom::families {

/// A point of a convex chain: abscissa and height, concave as a function of the abscissa.
struct ChainPoint {
  mpq_class along, height;
};
using Chain = std::vector<ChainPoint>;

/// The chain in the yz-plane, closed by (+-side, 0, -below). Every edge of the chain is an edge of the hull as long as the chain lies
/// above the two points, and its arc reaches as far across the plane as slope below / side.
Body fan(const Chain& chain, const mpq_class& side, const mpq_class& below);

/// A's fan: the same in the xz-plane, upside down, so that it is -A that has its chain on top.
Body opposing_fan(const Chain& chain, const mpq_class& side, const mpq_class& below);

/// A's fan and B's, B moved so that the highest point of P, where both chains have height 0, is at `top`.
Bodies crossed(const Chain& a, const Chain& b, const mpq_class& side, const mpq_class& below, const Point& top);

/// The even curve z(p) whose tangent with slope -x is z = x^2 / 2 * quadratic + x^4 * quartic - x p. In the chart z = 1 a body with this
/// outline has the support function x^2 / 2 * quadratic + x^4 * quartic, convex as long as quadratic + 12 quartic x^2 > 0.
struct Outline {
  mpq_class quadratic, quartic;
};

/// `count` values in [-width, width], ascending, one at random in the middle half of each of `count` equal parts: multiples of 2^-60,
/// at least width / count apart.
std::vector<mpz_class> spread_slopes(Random& random, unsigned count, const mpq_class& width);
inline constexpr long slope_bits = 60;

/// Returns the chain of the outline's tangents with the negatives of these slopes, cut off at the abscissae -reach and reach. `slopes` has
/// at least two elements, made by spread_slopes for this width. There is one edge for each slope. Corners are rounded to a grid that keeps
/// the chain strictly convex if the outline bends about as a unit circle does: multiples of 2^-least_bits if (count / width)^2 is less than
/// 2^(least_bits - 2). least_bits is at most 180.
Chain tangent_chain(const Outline& outline, const std::vector<mpz_class>& slopes, const mpq_class& width, const mpq_class& reach,
                    long least_bits = 50);

}  // namespace fathom::families
