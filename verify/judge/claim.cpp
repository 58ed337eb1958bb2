// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/claim.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"

namespace fathom::judging {
namespace {

/// x * 2^exponent, if that is a number of binary64.
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
  return *std::ranges::max_element(claim.contact_depths) - *claim.length;
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
    if (contact.depth) claim.contact_depths.push_back(length_of_claim(*contact.depth));
  }
  return claim;
}

}  // namespace fathom::judging
