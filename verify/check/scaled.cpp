// SPDX-License-Identifier: Apache-2.0
#include "scaled.hpp"

namespace fathom_check {
namespace {

class Scaling {
 public:
  Scaling(const mpz_class& scale, Arena& integers) : scale_(&scale), integers_(&integers) {}

  std::vector<Vector> points(const std::vector<RationalPoint>& points) {
    std::vector<Vector> result;
    result.reserve(points.size());
    for (const RationalPoint& p : points) result.push_back({times(p.x), times(p.y), times(p.z)});
    return result;
  }

 private:
  Integer times(const Rational& r) {
    if (mpz_cmp(r.den.get_mpz_t(), scale_->get_mpz_t()) == 0) return r.num;
    mpz_divexact(product_.get_mpz_t(), scale_->get_mpz_t(), r.den.get_mpz_t());
    mpz_mul(product_.get_mpz_t(), product_.get_mpz_t(), r.num.get_mpz_t());
    return integers_->keep(product_);
  }

  const mpz_class* scale_;
  Arena* integers_;
  mpz_class product_;
};

}  // namespace

Scaled scaled(const Certificate& certificate) {
  Scaled result;
  Scaling scaling(certificate.scale, result.integers);
  result.a = scaling.points(certificate.a.items);
  result.b = scaling.points(certificate.b.items);
  return result;
}

}  // namespace fathom_check
