// SPDX-License-Identifier: Apache-2.0
// Convex combinations of core points; a point of each core that is given by one: a common point, or
// two that are near to each other.
#include "budget.hpp"
#include "checks.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

void check_weight(const Weight& w, std::size_t points, std::size_t line) {
  if (w.index >= points) throw refused(line, "there is no point of this number");
  if (w.weight.num.sign() <= 0) throw refused(line, "a weight is positive: this one is not");
}

Combination combine(const Part<std::vector<Weight>>& part, const Points& points) {
  for (std::size_t k = 0; k < part.items.size(); ++k) check_weight(part.items[k], points.size(), part.lines[k]);
  return convex_combination(part.items.data(), part.items.data() + part.items.size(), points, part.line);
}

}  // namespace

Combination convex_combination(const Weight* begin, const Weight* end, const Points& points, std::size_t line) {
  Combination result;
  for (const Weight* w = begin; w != end; ++w) {
    check_weight(*w, points.size(), line);
    mpz_lcm(result.den.get_mpz_t(), result.den.get_mpz_t(), w->weight.den.get_mpz_t());
  }
  mpz_class total = 0, factor;
  for (; begin != end; ++begin) {
    const Weight& w = *begin;
    mpz_divexact(factor.get_mpz_t(), result.den.get_mpz_t(), w.weight.den.get_mpz_t());
    mpz_mul(factor.get_mpz_t(), factor.get_mpz_t(), w.weight.num.get_mpz_t());
    const Vector& p = points[w.index];
    total += factor;
    mpz_addmul(result.sum.x.get_mpz_t(), factor.get_mpz_t(), p.x.get_mpz_t());
    mpz_addmul(result.sum.y.get_mpz_t(), factor.get_mpz_t(), p.y.get_mpz_t());
    mpz_addmul(result.sum.z.get_mpz_t(), factor.get_mpz_t(), p.z.get_mpz_t());
  }
  if (total != result.den) throw refused(line, "these weights do not sum to 1");
  return result;
}

void check_weights(const Certificate& c, const Points& points_a, const Points& points_b, const Bound& low) {
  const Combination a = combine(c.weights_a, points_a), b = combine(c.weights_b, points_b);
  const MutableVector z{b.sum.x * a.den - a.sum.x * b.den, b.sum.y * a.den - a.sum.y * b.den,
                        b.sum.z * a.den - a.sum.z * b.den};
  mpz_class squared;  // times (a.den b.den)^2
  dot(squared, z, z);
  const mpz_class den = a.den * b.den;
  if (squared * low.den <= -low.num * den * den) return;
  const bool common = c.claim == Claim::touching;
  throw refused(c.weights_b.line, common ? "the weights of a and of b yield different points"
                                         : "the weights yield points that are too far apart");
}

}  // namespace fathom_check
