// SPDX-License-Identifier: Apache-2.0
#include "scaled.hpp"

namespace fathom_check {
namespace {

mpz_class times(const Rational& r, const mpz_class& scale) {
  if (r.den == scale) return r.num;
  mpz_class factor;
  mpz_divexact(factor.get_mpz_t(), scale.get_mpz_t(), r.den.get_mpz_t());
  return r.num * factor;
}

std::vector<Vector> scaled_points(const std::vector<RationalPoint>& points, const mpz_class& scale) {
  std::vector<Vector> result;
  result.reserve(points.size());
  for (const RationalPoint& p : points) result.push_back({times(p.x, scale), times(p.y, scale), times(p.z, scale)});
  return result;
}

}  // namespace

Scaled scaled(const Certificate& certificate) {
  return {scaled_points(certificate.a.items, certificate.scale), scaled_points(certificate.b.items, certificate.scale)};
}

}  // namespace fathom_check
