// SPDX-License-Identifier: Apache-2.0
// A common point of both bodies, given by convex combinations.
#include "budget.hpp"
#include "checks.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

/// The sum of weight * point, over a common denominator of the weights.
struct Combination {
  Vector sum;
  mpz_class den = 1;
};

void check_weight(const Weight& w, std::size_t points, std::size_t line) {
  if (w.index >= points) throw refused(line, "there is no point of this number");
  if (w.weight.num <= 0) throw refused(line, "a weight is positive: this one is not");
}

Combination combine(const Part<std::vector<Weight>>& part, const std::vector<Vector>& points) {
  Combination result;
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    check_weight(part.items[k], points.size(), part.lines[k]);
    result.den = lcm(result.den, part.items[k].weight.den);
  }
  mpz_class total = 0;
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    const Weight& w = part.items[k];
    const mpz_class factor = w.weight.num * (result.den / w.weight.den);
    const Vector& p = points[w.index];
    total += factor;
    add(result.sum, {factor * p.x, factor * p.y, factor * p.z});
  }
  if (total != result.den) throw refused(part.line, "these weights do not sum to 1");
  return result;
}

}  // namespace

void check_weights(const Certificate& c, const Scaled& bodies) {
  const Combination a = combine(c.weights_a, bodies.a);
  const Combination b = combine(c.weights_b, bodies.b);
  const bool equal = a.sum.x * b.den == b.sum.x * a.den && a.sum.y * b.den == b.sum.y * a.den && a.sum.z * b.den == b.sum.z * a.den;
  if (!equal) throw refused(c.weights_b.line, "the weights of a and of b yield different points");
}

}  // namespace fathom_check
