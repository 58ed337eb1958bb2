// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/half_space.hpp"

#include <numeric>
#include <utility>

#include "kernels/vector.hpp"
#include "reference/curved/assembly.hpp"

namespace fathom::curved {
namespace {

// The least multiple > 0 of a vector of rationals that is integral and primitive.
mpq_class factor_of(const Point& m) {
  const mpz_class denominator = lcm(lcm(m.x.get_den(), m.y.get_den()), m.z.get_den());
  const mpz_class factor = gcd(gcd(mpz_class(m.x * denominator), mpz_class(m.y * denominator)), mpz_class(m.z * denominator));
  mpq_class result(denominator, factor);
  result.canonicalize();
  return result;
}

// The point of a term that reaches its height exactly.
AtomPoint reaching(const Term& term, const Vector& n, const mpq_class& height) {
  TightAtom tight = std::move(tight_atoms(term, n, height).front());
  return {tight.atom, std::move(tight.local)};
}

}  // namespace

CurvedBounds half_space_bounds(kernels::Context& context, const HalfSpace& plane, const Shape& other, bool plane_is_a,
                               const mpq_class& radius, unsigned bits) {
  const auto& terms = std::get<std::vector<Term>>(other.core);
  const Lattice points = plane_is_a ? lattice({}, terms, bits + 6) : lattice(terms, {}, bits + 6);
  const Goal goal(bits, bits, points.extent * points.unit + 2 * (radius + other.radius), radius + other.radius);
  const mpq_class factor = factor_of(plane.normal);
  const Point& m = plane.normal;
  const Vector outward{mpz_class(m.x * factor), mpz_class(m.y * factor), mpz_class(m.z * factor)};
  CurvedBounds result;
  Vector& n = result.bracket.direction;
  n = plane_is_a ? Vector(-outward) : outward;
  const Vector s = -outward;  // in which the other core is to be seen

  Oracle oracle(context, points, 1);
  oracle.ask(n, points.fine);
  result.support_calls = 1;
  const std::vector<TermHeight> heights = oracle.heights(n);
  InnerPoint inner = oracle.inner_point(0, !plane_is_a);
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (heights[t].exact) inner[t] = reaching(terms[t], s, heights[t].height);

  std::vector<mpq_class> rounded = short_heights(heights, n, goal);
  const mpq_class offset = plane.offset * factor;
  mpq_class low = offset;
  for (std::size_t t = 0; t < terms.size(); ++t) low += dot(s, place(terms[t].atoms[inner[t].atom], inner[t].local));
  const mpq_class lower = signed_square(low, n), upper = signed_square(std::accumulate(rounded.begin(), rounded.end(), offset), n);
  result.low = lower == upper ? goal.exact_or_below(lower) : goal.from_below(lower);
  result.high = lower == upper ? goal.exact_or_above(upper) : goal.from_above(upper);
  (plane_is_a ? result.bracket.heights_b : result.bracket.heights_a) = std::move(rounded);
  (plane_is_a ? result.bracket.inner_b : result.bracket.inner_a) = std::vector<InnerPoint>{std::move(inner)};
  return result;
}

}  // namespace fathom::curved
