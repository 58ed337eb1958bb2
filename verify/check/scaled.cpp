// SPDX-License-Identifier: Apache-2.0
#include "scaled.hpp"

#include <algorithm>

#include "vectors.hpp"

namespace fathom_check {
namespace {

/// The least common multiple of denominators. Each coordinate will grow by what it grows by, and that is paid for first.
class CommonDenominator {
 public:
  CommonDenominator(Budget& budget, std::size_t coordinates) : budget_(&budget), coordinates_(coordinates) {}

  void take(const mpz_class& den, std::size_t line) {
    if (mpz_divisible_p(value_.get_mpz_t(), den.get_mpz_t())) return;
    constexpr std::uint64_t gcd_cost = 16;  // in products of that size
    const std::uint64_t before = bits(value_);
    budget_->work(gcd_cost * (before + bits(den)), line);
    value_ = lcm(value_, den);
    budget_->store((bits(value_) - before) / 8 * coordinates_, line);
  }
  void take(const Part<std::vector<RationalPoint>>& points) {
    for (std::size_t k = 0; k < points.items.size(); ++k) {
      const RationalPoint& p = points.items[k];
      for (const Rational* r : {&p.x, &p.y, &p.z}) take(r->den, points.lines[k]);
    }
  }
  [[nodiscard]] const mpz_class& value() const { return value_; }

 private:
  Budget* budget_;
  std::size_t coordinates_;
  mpz_class value_ = 1;
};

mpz_class times(const Rational& r, const mpz_class& scale) {
  if (r.den == scale) return r.num;
  mpz_class factor;
  mpz_divexact(factor.get_mpz_t(), scale.get_mpz_t(), r.den.get_mpz_t());
  return r.num * factor;
}

void scale_points(const Part<std::vector<RationalPoint>>& part, const mpz_class& scale, std::vector<Vector>& result, std::uint64_t& widest,
                  Budget& budget) {
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    const RationalPoint& p = part.items[k];
    const std::uint64_t size = bits(p.x.num) + bits(p.y.num) + bits(p.z.num);
    budget.store(sizeof(Vector) + 3 * mpz_bytes + size / 8, part.lines[k]);
    budget.work(size + 3 * bits(scale), part.lines[k]);
    result.push_back({times(p.x, scale), times(p.y, scale), times(p.z, scale)});
    widest = std::max(widest, bits(result.back()));
  }
}

}  // namespace

Scaled scaled(const Certificate& certificate, Budget& budget) {
  CommonDenominator common(budget, 3 * (certificate.a.items.size() + certificate.b.items.size()));
  common.take(certificate.a);
  common.take(certificate.b);
  Scaled result;
  result.scale = common.value();
  scale_points(certificate.a, result.scale, result.a, result.widest, budget);
  scale_points(certificate.b, result.scale, result.b, result.widest, budget);
  return result;
}

}  // namespace fathom_check
