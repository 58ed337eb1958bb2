// SPDX-License-Identifier: Apache-2.0
// A point of each core, given by convex combinations of its core points: a common one, or two that
// are near to each other.
#include "budget.hpp"
#include "checks.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

/// The sum of weight * point, over a common denominator of the weights.
struct Combination {
  MutableVector sum;
  mpz_class den = 1;
};

void check_weight(const Weight& w, std::size_t points, std::size_t line) {
  if (w.index >= points) throw refused(line, "there is no point of this number");
  if (w.weight.num.sign() <= 0) throw refused(line, "a weight is positive: this one is not");
}

Combination combine(const Part<std::vector<Weight>>& part, const Points& points) {
  Combination result;
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    check_weight(part.items[k], points.size(), part.lines[k]);
    mpz_lcm(result.den.get_mpz_t(), result.den.get_mpz_t(), part.items[k].weight.den.get_mpz_t());
  }
  mpz_class total = 0, factor;
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    const Weight& w = part.items[k];
    mpz_divexact(factor.get_mpz_t(), result.den.get_mpz_t(), w.weight.den.get_mpz_t());
    mpz_mul(factor.get_mpz_t(), factor.get_mpz_t(), w.weight.num.get_mpz_t());
    const Vector& p = points[w.index];
    total += factor;
    mpz_addmul(result.sum.x.get_mpz_t(), factor.get_mpz_t(), p.x.get_mpz_t());
    mpz_addmul(result.sum.y.get_mpz_t(), factor.get_mpz_t(), p.y.get_mpz_t());
    mpz_addmul(result.sum.z.get_mpz_t(), factor.get_mpz_t(), p.z.get_mpz_t());
  }
  if (total != result.den) throw refused(part.line, "these weights do not sum to 1");
  return result;
}

}  // namespace

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
