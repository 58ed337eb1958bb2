// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/claim.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"

namespace fathom::judging {
namespace {

/// Returns x * 2^exponent, if that is a number of binary64.
std::optional<double> same_in_unit(double x, int exponent) {
  const double there = std::ldexp(x, exponent);
  return std::isfinite(there) && std::ldexp(there, -exponent) == x ? std::optional(there) : std::nullopt;
}

std::optional<Point> point_of(const std::optional<Triple>& p) {
  if (!p || !is_finite(*p)) return std::nullopt;
  return exact_point(*p);
}

std::optional<Point> point_of(const std::optional<Triple>& p, long exponent) {
  std::optional<Point> point = point_of(p);
  if (point && exponent != 0)
    for (mpq_class* x : {&point->x, &point->y, &point->z}) *x = scaled(*x, -exponent);
  return point;
}

struct Digits {
  long bits, least_exponent;
};

constexpr Digits digits_of(Precision precision) {
  return precision == Precision::binary64 ? Digits{53, -1074} : Digits{24, -149};
}

mpq_class power_of_two(long exponent) { return scaled(1, exponent); }

/// Returns the e with 2^e <= sqrt(squared) < 2^(e+1), for a square above 0.
long exponent_of_root(const mpq_class& squared) {
  long e = (kernels::binary_order(squared) - 1) >> 1;  // a lower bound, too small by 1 at most
  while (power_of_two(2 * (e + 1)) <= squared) ++e;
  return e;
}

mpq_class square(const mpq_class& x) { return x * x; }

/// Returns whether |d - sqrt(squared)| <= t.
bool within(const mpq_class& d, const mpq_class& squared, const mpq_class& t) {
  return sign({d - t, -squared}) <= 0 && sign({d + t, -squared}) >= 0;
}

/// Returns whether d is the depth, correctly rounded to the format. A depth beyond its range has no
/// such number.
bool correctly_rounded(const mpq_class& d, const mpq_class& squared, const NumberFormat& format) {
  const mpq_class there = scaled(squared, 2 * format.exponent);
  const double nearest =
      format.answers == Precision::binary64 ? root_binary64(there, Rounding::rn) : root_binary32(there, Rounding::rn);
  return std::isfinite(nearest) && exact_value(nearest) == scaled(d, format.exponent);
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

Point exact_point(const Triple& p) { return {exact_value(p[0]), exact_value(p[1]), exact_value(p[2])}; }

bool is_finite(const Triple& p) {
  return std::ranges::all_of(p, [](double x) { return std::isfinite(x); });
}

bool is_finite(const ContactPoint& contact) {
  return is_finite(contact.position) && (!contact.depth || std::isfinite(*contact.depth));
}

const double* length_of(const Reply& reply) {
  const std::optional<double>& length = reply.overlap ? reply.depth : reply.distance;
  return length ? &*length : nullptr;
}

std::optional<mpq_class> deepest_contact(const Claim& claim) {
  if (!claim.length || claim.contact_depths.empty()) return std::nullopt;
  const std::optional<mpq_class>& deepest = *std::ranges::max_element(claim.contact_depths);  // nullopt is least
  return deepest ? std::optional<mpq_class>(*deepest - *claim.length) : std::nullopt;
}

Claim exact_claim(const Reply& reply, const Conventions& conventions, long exponent) {
  Claim claim;
  claim.overlap = reply.overlap;
  const double* const length = length_of(reply);
  if (!reply.overlap && !length) return claim;
  const auto length_of_claim = [&](double given) {
    const mpq_class value = scaled(exact_value(given), -exponent);
    return reply.overlap && conventions.depth == Conventions::Sign::negative ? mpq_class(-value) : value;
  };
  if (length) {
    claim.finite = std::isfinite(*length);
    for (const auto* p : {&reply.direction, &reply.witness_a, &reply.witness_b}) claim.finite &= !*p || is_finite(**p);
    if (std::isfinite(*length)) claim.length = length_of_claim(*length);
  }
  if (const std::optional<Point> u = point_of(reply.direction)) {
    claim.direction_length = u->x * u->x + u->y * u->y + u->z * u->z;
    const Vector v = primitive_along(*u);
    if (!is_zero(v)) claim.direction = conventions.moves == Conventions::Body::b ? -v : v;
  }
  claim.witness_a = point_of(reply.witness_a, exponent);
  claim.witness_b = point_of(reply.witness_b, exponent);
  if (!reply.overlap || !length) return claim;
  if (!std::ranges::all_of(reply.contacts, [](const ContactPoint& contact) { return is_finite(contact); })) {
    claim.finite = false;
    return claim;
  }
  for (const ContactPoint& contact : reply.contacts) {
    claim.contacts.push_back(*point_of(contact.position, exponent));
    claim.contact_depths.push_back(contact.depth ? std::optional(length_of_claim(*contact.depth)) : std::nullopt);
  }
  return claim;
}

mpq_class ulp_at_root(const mpq_class& squared, const NumberFormat& format) {
  const Digits digits = digits_of(format.answers);
  const long least = digits.least_exponent - format.exponent;
  return power_of_two(sgn(squared) == 0 ? least : std::max(exponent_of_root(squared) - digits.bits + 1, least));
}

mpq_class unit_roundoff(Precision precision) { return power_of_two(-digits_of(precision).bits); }

Slack rounding_slack(const Sizes& sizes, const mpq_class& depth_squared, const NumberFormat& format,
                     unsigned long ulps) {
  const mpq_class most = std::max(mpq_class(ulps), mpq_class(1, 2)),
                  of_depth = most * ulp_at_root(depth_squared, format),
                  of_point = most * ulp_at_root(square(sizes.farthest), format),
                  of_direction = most * 4 * unit_roundoff(format.answers) * sizes.reach;
  return {of_depth, of_depth + of_direction, mpq_class(7, 4) * of_point, 3 * of_depth + mpq_class(7, 2) * of_point};
}

Allowance::Allowance(const mpq_class& relative, const mpq_class& depth_squared, const mpq_class& fixed)
    : fixed_(std::max(mpq_class(0), fixed)),
      proportional_(sgn(relative) > 0 ? mpq_class(square(relative) * depth_squared) : mpq_class(0)),
      squared_(std::max(proportional_, square(fixed_))) {}

Allowances::Allowances(const Sizes& sizes, const mpq_class& depth_squared, const NumberFormat& format,
                       const Tolerance& tolerance) {
  for (const mpq_class* part : {&tolerance.relative, &tolerance.absolute}) kernels::require_lowest_terms(*part);
  const mpq_class absolute = tolerance.absolute * sizes.extent;
  const Slack slack = rounding_slack(sizes, depth_squared, format, tolerance.ulps);
  const auto allowed = [&](const mpq_class& length) {
    return Allowance(tolerance.relative, depth_squared, std::max(absolute, length));
  };
  classification = allowed(tolerance.ulps * ulp_at_root(depth_squared, format));
  depth = allowed(slack.depth);
  direction = allowed(slack.direction);
  witness = allowed(slack.witness);
  gap = allowed(slack.gap);
}

bool Allowance::above(const mpq_class& d, const mpq_class& length) const {
  return sign({d - fixed_, -length}) > 0 && kernels::sign_of_sum(d, -length, -proportional_) > 0;
}

bool Allowance::below(const mpq_class& d, const mpq_class& length) const {
  return sign({-d - fixed_, length}) > 0 && kernels::sign_of_sum(-d, length, -proportional_) > 0;
}

bool Allowance::negligible(const Surd& squared) const { return sign({squared.rational - squared_, squared.root}) <= 0; }

bool Allowance::negligible(const mpq_class& squared, const mpq_class& beside) const {
  const mpq_class other = square(beside);
  return sign({squared - squared_ - other, -4 * squared_ * other}) <= 0;
}

Accuracy accuracy_of(const mpq_class& d, const mpq_class& depth_squared, const mpq_class& u_r,
                     const NumberFormat& format) {
  if (correctly_rounded(d, depth_squared, format)) return Accuracy::correctly_rounded;
  if (within(d, depth_squared, 4 * ulp_at_root(depth_squared, format))) return Accuracy::ulps_4;
  if (within(d, depth_squared, 16 * u_r)) return Accuracy::u_r_16;
  const mpq_class millionth(1, 1'000'000);  // (1 - e) depth <= d <= (1 + e) depth
  const bool close = sgn(d) >= 0 && square(d) >= square(1 - millionth) * depth_squared &&
                     square(d) <= square(1 + millionth) * depth_squared;
  return close ? Accuracy::millionth : Accuracy::tolerance;
}

}  // namespace fathom::judging
