// SPDX-License-Identifier: GPL-3.0-or-later
// Subsets of the generators are tried, largest first: the nearest point z of the cone is the orthogonal projection onto the span of its
// support, with positive weights there and <target - z, g> <= 0 for all generators g. These conditions are also sufficient, and as the
// generators are independent exactly one subset meets them.
#include "reference/polytope/position_cone.hpp"

#include <array>
#include <bit>
#include <stdexcept>

namespace fathom::polytope {
namespace {

constexpr std::size_t most = 4;
using Row = std::array<mpz_class, most + 1>;
using Matrix = std::array<Row, most>;  // products of generators; the last column holds those with the target

Matrix gram(std::span<const Lifted> generators, const Lifted& target) {
  const std::size_t n = generators.size();
  Matrix m;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) m[i][j] = m[j][i] = dot(generators[i], generators[j]);
    m[i][most] = dot(generators[i], target);
  }
  return m;
}

struct Solution {
  std::vector<mpz_class> numerators;
  mpz_class determinant;
};

// The weights of the projection onto the span of `support`, by fraction-free elimination (Bareiss, Gauss-Jordan form). A Gram matrix of
// independent vectors is positive definite: every pivot is positive, and so is the determinant.
Solution project(const Matrix& gram, const std::vector<std::size_t>& support) {
  const std::size_t n = support.size();
  Matrix m;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = gram[support[i]][support[j]];
    m[i][n] = gram[support[i]][most];
  }
  Solution s;
  s.determinant = 1;
  mpz_class next;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      for (std::size_t j = k + 1; j <= n; ++j) {
        mpz_mul(next.get_mpz_t(), m[k][k].get_mpz_t(), m[i][j].get_mpz_t());
        mpz_submul(next.get_mpz_t(), m[i][k].get_mpz_t(), m[k][j].get_mpz_t());
        mpz_divexact(m[i][j].get_mpz_t(), next.get_mpz_t(), s.determinant.get_mpz_t());
      }
    }
    s.determinant = m[k][k];
  }
  for (std::size_t i = 0; i < n; ++i) s.numerators.push_back(m[i][n]);
  return s;
}

void divide_by_common_divisor(Lifted& g) {
  const mpz_class d = gcd(gcd(gcd(g.w, g.v.x), g.v.y), g.v.z);
  if (d <= 1) return;
  for (mpz_class* c : {&g.v.x, &g.v.y, &g.v.z, &g.w}) mpz_divexact(c->get_mpz_t(), c->get_mpz_t(), d.get_mpz_t());
}

// determinant * target - sum of numerators * generators, without its common divisor.
Lifted residual(std::span<const Lifted> generators, const Lifted& target, const std::vector<std::size_t>& support, const Solution& s) {
  Lifted r{{s.determinant * target.v.x, s.determinant * target.v.y, s.determinant * target.v.z}, s.determinant * target.w};
  for (std::size_t i = 0; i < support.size(); ++i) {
    const Lifted& g = generators[support[i]];
    r.v.x -= s.numerators[i] * g.v.x;
    r.v.y -= s.numerators[i] * g.v.y;
    r.v.z -= s.numerators[i] * g.v.z;
    r.w -= s.numerators[i] * g.w;
  }
  divide_by_common_divisor(r);
  return r;
}

bool all_positive(const std::vector<mpz_class>& weights) {
  for (const mpz_class& w : weights)
    if (w <= 0) return false;
  return true;
}

bool reaches_none(const Lifted& residual, std::span<const Lifted> generators, unsigned subset) {
  for (std::size_t i = 0; i < generators.size(); ++i)
    if ((subset >> i & 1U) == 0 && dot(residual, generators[i]) > 0) return false;
  return true;
}

}  // namespace

mpz_class dot(const Lifted& g, const Lifted& h) {
  mpz_class r = g.w * h.w;
  mpz_addmul(r.get_mpz_t(), g.v.x.get_mpz_t(), h.v.x.get_mpz_t());
  mpz_addmul(r.get_mpz_t(), g.v.y.get_mpz_t(), h.v.y.get_mpz_t());
  mpz_addmul(r.get_mpz_t(), g.v.z.get_mpz_t(), h.v.z.get_mpz_t());
  return r;
}

NearestInCone nearest_in_cone(std::span<const Lifted> generators, const Lifted& target) {
  const std::size_t n = generators.size();
  if (n == 0 || n > most) throw std::logic_error("nearest_in_cone: one to four generators expected");
  const Matrix products = gram(generators, target);
  const unsigned last = 1U << (n - 1), all = 2 * last - 1;
  for (int size = static_cast<int>(n); size > 0; --size) {
    for (unsigned subset = last; subset <= all; ++subset) {
      if (std::popcount(subset) != size) continue;
      NearestInCone z;
      for (std::size_t i = 0; i < n; ++i)
        if (subset >> i & 1U) z.support.push_back(i);
      Solution s = project(products, z.support);
      if (!all_positive(s.numerators)) continue;
      z.residual = residual(generators, target, z.support, s);
      if (!reaches_none(z.residual, generators, subset)) continue;
      z.weights = std::move(s.numerators);
      z.denominator = std::move(s.determinant);
      return z;
    }
  }
  throw std::logic_error("nearest_in_cone: the last generator is not needed, or the generators are dependent");
}

}  // namespace fathom::polytope
