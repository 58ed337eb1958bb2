// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

/// The corners of the rounded edge's cross-section, in units of 1/256: abscissa across the chain, and height. The arc of a chain edge is
/// cut where the slope across the chain is 1 and -1.
constexpr std::pair<int, int> cross_section[] = {{-1, -1}, {0, 0}, {1, -1}};
constexpr long unit_bits = 8;

/// The bar over the chain in the yz-plane.
Body bar(const Chain& chain) {
  Body body = fan({}, 1, 4);
  body.points.reserve(3 * chain.size() + 2);
  for (const auto& [across, height] : cross_section) {
    const mpq_class x = times_power_of_two(across, -unit_bits), z = times_power_of_two(height, -unit_bits);
    for (const ChainPoint& p : chain) body.points.push_back({x, p.along, mpq_class(p.height + z)});
  }
  return body;
}

/// Turned about the z-axis, and stretched by the square root of 10 across it: the y-axis goes to (x, y, 0).
Body laid_along(const Body& body, int x, int y) {
  Body result;
  result.points.reserve(body.points.size());
  for (const Point& p : body.points) result.points.push_back({mpq_class(y * p.x + x * p.y), mpq_class(y * p.y - x * p.x), p.z});
  return result;
}

Body upside_down(Body body) {
  for (Point& p : body.points.edit()) p.z = -p.z;
  return body;
}

/// The height falls off along the bar as that of a parabola with the curvature 1/5 does, in its stretched unit; the bisectors of (3, 1) and
/// (1, 3) meet this as curvatures of 4/5 and 16/5.
Chain arc(Random& random, unsigned edges, const mpq_class& quartic) {
  const mpq_class width = 2;
  return tangent_chain({ratio(1, 5), quartic}, spread_slopes(random, edges, width), width, ratio(1, 2));
}

}  // namespace

Bodies crossed_fillets(Random& random, unsigned n) {
  const unsigned edges = std::max(2U, (n + 1) / 2);
  const Body a = bar(arc(random, edges, ratio(-1, 1024))), b = bar(arc(random, edges, ratio(1, 1024)));
  Point top = random_shift(random, 1);
  top = {times_power_of_two(top.x, -16), times_power_of_two(top.y, -16), 1};
  return {upside_down(laid_along(a, 3, 1)), translated(laid_along(b, 1, 3), top)};
}

}  // namespace fathom::families
