// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/allowance.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/number/parse.hpp"
#include "kernels/number/rounding.hpp"

namespace fathom {
namespace {

struct Format {
  long bits, least_exponent;
};

constexpr Format format(Precision precision) { return precision == Precision::binary64 ? Format{53, -1074} : Format{24, -149}; }

mpq_class power_of_two(long exponent) {
  mpq_class one = 1;
  if (exponent >= 0) mpq_mul_2exp(one.get_mpq_t(), one.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(one.get_mpq_t(), one.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return one;
}

long bit_length(const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); }

/// The e with 2^e <= sqrt(squared) < 2^(e+1). For a square above 0.
long exponent_of_root(const mpq_class& squared) {
  long e = (bit_length(squared.get_num()) - bit_length(squared.get_den()) - 1) >> 1;  // at most that, and short by 1 at most
  while (power_of_two(2 * (e + 1)) <= squared) ++e;
  return e;
}

mpq_class square(const mpq_class& x) { return x * x; }

/// |d - sqrt(squared)| <= t.
bool within(const mpq_class& d, const mpq_class& squared, const mpq_class& t) {
  return sign({d - t, -squared}) <= 0 && sign({d + t, -squared}) >= 0;
}

/// Whether d is the depth, correctly rounded to the format. A depth beyond it has no such number.
bool correctly_rounded(const mpq_class& d, const mpq_class& squared, Precision precision) {
  const double nearest = precision == Precision::binary64 ? root_binary64(squared, Rounding::rn) : root_binary32(squared, Rounding::rn);
  return std::isfinite(nearest) && exact_value(nearest) == d;
}

}  // namespace

mpq_class ulp_at_root(const mpq_class& squared, Precision precision) {
  const Format f = format(precision);
  return power_of_two(sgn(squared) == 0 ? f.least_exponent : std::max(exponent_of_root(squared) - f.bits + 1, f.least_exponent));
}

mpq_class unit_roundoff(Precision precision) { return power_of_two(-format(precision).bits); }

Allowance::Allowance(const Scene& scene, const Depth& depth, Precision precision, const Tolerance& tolerance)
    : depth_squared_(depth.squared),
      ulp_(ulp_at_root(depth.squared, precision)),
      u_r_(unit_roundoff(precision) * scene.farthest()),
      fixed_(std::max({mpq_class(0), mpq_class(tolerance.absolute * scene.extent()), mpq_class(tolerance.ulps * ulp_)})),
      proportional_(sgn(tolerance.relative) > 0 ? mpq_class(square(tolerance.relative) * depth.squared) : mpq_class(0)),
      squared_(std::max(proportional_, square(fixed_))) {}

bool Allowance::above(const mpq_class& d, const mpq_class& length) const {
  return sign({d - fixed_, -length}) > 0 && sign_of_sum(d, -length, -proportional_) > 0;
}

bool Allowance::below(const mpq_class& d, const mpq_class& length) const {
  return sign({-d - fixed_, length}) > 0 && sign_of_sum(-d, length, -proportional_) > 0;
}

bool Allowance::negligible(const Surd& squared) const { return sign({squared.rational - squared_, squared.root}) <= 0; }

Accuracy accuracy_of(const mpq_class& d, const Allowance& allowance, Precision precision) {
  const mpq_class& depth = allowance.depth_squared();
  if (correctly_rounded(d, depth, precision)) return Accuracy::correctly_rounded;
  if (within(d, depth, 4 * allowance.ulp())) return Accuracy::ulps_4;
  if (within(d, depth, 16 * allowance.rounding_unit())) return Accuracy::u_r_16;
  const mpq_class millionth(1, 1'000'000);  // (1 - e) depth <= d <= (1 + e) depth
  const bool close = sgn(d) >= 0 && square(d) >= square(1 - millionth) * depth && square(d) <= square(1 + millionth) * depth;
  return close ? Accuracy::millionth : Accuracy::tolerance;
}

std::string_view name(Accuracy accuracy) {
  constexpr std::string_view names[] = {"correctly rounded", "4 ulp", "16 uR", "1e-6", "tolerance"};
  return names[static_cast<std::size_t>(accuracy)];
}

}  // namespace fathom
