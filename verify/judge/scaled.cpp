// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "verify/judge/claim.hpp"

namespace fathom::judging {
namespace {

/// x * 2^exponent, if that is a number of binary64.
std::optional<double> same_in_unit(double x, int exponent) {
  const double there = std::ldexp(x, exponent);
  return std::isfinite(there) && std::ldexp(there, -exponent) == x ? std::optional(there) : std::nullopt;
}

}  // namespace

mpq_class scaled(const mpq_class& value, long exponent) {
  mpq_class result;
  if (exponent >= 0) mpq_mul_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(result.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

GivenPoints scaled(const GivenPoints& points, long exponent) {
  if (points.in_binary64()) {
    std::vector<std::array<double, 3>> result(points.binary64().begin(), points.binary64().end());
    const bool same = std::ranges::all_of(result, [&](std::array<double, 3>& p) {
      return std::ranges::all_of(p, [&](double& x) {
        const std::optional<double> there = same_in_unit(x, static_cast<int>(exponent));
        if (there) x = *there;
        return there.has_value();
      });
    });
    if (same) return GivenPoints(std::move(result));
  }
  std::vector<Point> result = points.exact();
  for (Point& p : result)
    for (mpq_class* x : {&p.x, &p.y, &p.z}) *x = scaled(*x, exponent);
  return result;
}

}  // namespace fathom::judging
