// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

/// Five times the body, turned about the z-axis by the angle with the sine 4/5: exact, and the arcs of fans are neither upright nor level.
Body askew(const Body& body) {
  Body result;
  result.points.reserve(body.points.size());
  for (const Point& p : body.points)
    result.points.push_back({mpq_class(3 * p.x - 4 * p.y), mpq_class(4 * p.x + 3 * p.y), mpq_class(5 * p.z)});
  return result;
}

/// The chains reach out to 2 along their tangents, where P is farther from O than 1 in every direction but the patch's.
Bodies tie_patch(Random& random, unsigned n, const mpq_class& width, long least_bits = 50) {
  const Outline outline{mpq_class(1 - width * width / 4), ratio(-1, 8)};
  const Chain a = tangent_chain(outline, spread_slopes(random, n, width), width, 2, least_bits);
  const Chain b = tangent_chain(outline, spread_slopes(random, n, width), width, 2, least_bits);
  const Bodies bodies = crossed(a, b, 2, 4, {0, 0, 1});
  return {askew(bodies.a), askew(bodies.b)};
}

unsigned edges_of(unsigned n) { return std::max(3U, n); }

}  // namespace

Bodies crossed_ties(Random& random, unsigned n) { return tie_patch(random, edges_of(n), ratio(1, 32)); }

Bodies crossed_shrinking_ties(Random& random, unsigned n) {
  const unsigned edges = edges_of(n);
  const mpz_class square = (mpz_class(1) << (2 * slope_bits)) / (2 * edges);
  return tie_patch(random, edges, times_power_of_two(mpq_class(sqrt(square)), -slope_bits));
}

Bodies crossed_vanishing_ties(Random& random, unsigned n) {
  const unsigned edges = edges_of(n);
  return tie_patch(random, edges, ratio(1, edges));
}

Bodies crossed_noisy_ties(Random& random, unsigned n) {
  const unsigned edges = edges_of(n);
  const long bits = random.between(50, 90);
  return tie_patch(random, edges, ratio(1, edges), bits);
}

}  // namespace fathom::families
