// SPDX-License-Identifier: GPL-3.0-or-later
// Places for pixels: input coordinates, moved and scaled by a power of two only where binary64 needs it.
#include <algorithm>
#include <cmath>

#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"
#include "view/stages/parts.hpp"

namespace fathom::stages {
namespace {

// Far from O, a body's digits are those of its place: then places count from the body. So they do if it is farther than this many extents.
constexpr int near_origin = 4;

// Beyond this power of two, squares and products of places would leave binary64.
constexpr long comfortable_exponent = 300;

mpq_class largest(const Point& p) { return std::max({mpq_class(abs(p.x)), mpq_class(abs(p.y)), mpq_class(abs(p.z))}); }

long bits(const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); }

mpq_class times_power_of_two(mpq_class value, long exponent) {
  if (exponent >= 0) mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  else mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return value;
}

mpq_class extent_of(const polytope::PlacedPair& pair) {
  mpz_class most;
  for (const kernels::PointCloud* cloud : {&pair.a, &pair.b}) {
    for (const Vector& p : cloud->points()) {
      for (const mpz_class* c : {&p.x, &p.y, &p.z}) {
        if (mpz_cmpabs(c->get_mpz_t(), most.get_mpz_t()) > 0) most = abs(*c);
      }
    }
  }
  mpq_class extent(most, pair.denominator);
  extent.canonicalize();
  return extent;
}

// The component of a direction whose components have at most so many bits, over 2^most.
double component(const mpz_class& c, long most) {
  long exponent = 0;
  const double fraction = mpz_get_d_2exp(&exponent, c.get_mpz_t());
  return std::ldexp(fraction, static_cast<int>(std::max(exponent - most, -2000L)));
}

}  // namespace

StagedScale scale_of(const Point& origin, const mpq_class& extent) {
  StagedScale scale;
  const mpq_class distance = largest(origin);
  if (distance > near_origin * extent) scale.center = origin;
  const mpq_class& size = distance > near_origin * extent ? extent : std::max(extent, distance);
  if (size == 0) return scale;
  const long exponent = bits(size.get_num()) - bits(size.get_den());
  if (std::abs(exponent) > comfortable_exponent) scale.exponent = -exponent;
  return scale;
}

double scaled(const mpq_class& value, const StagedScale& scale) { return round_binary64(times_power_of_two(value, scale.exponent)) + 0.0; }

double scaled_root(const mpq_class& squared, const StagedScale& scale) {
  return root_binary64(times_power_of_two(squared, 2 * scale.exponent));
}

Placing::Placing(const polytope::PlacedPair& pair) : scale_(scale_of(pair.origin, extent_of(pair))), pair_(&pair) {}

Place Placing::point(const Vector& lattice) const { return point(pair_->position(lattice)); }

Place Placing::vector(const Vector& lattice) const {
  return vector(Point{{lattice.x, pair_->denominator}, {lattice.y, pair_->denominator}, {lattice.z, pair_->denominator}});
}

Place Placing::point(const Point& p) const { return vector(p - scale_.center); }

Place Placing::vector(const Point& v) const { return {scaled(v.x, scale_), scaled(v.y, scale_), scaled(v.z, scale_)}; }

double Placing::length(const mpq_class& squared) const { return scaled_root(squared, scale_); }

Place unit(const Vector& direction) {
  const long most = std::max({bits(direction.x), bits(direction.y), bits(direction.z)});
  const Place v{component(direction.x, most), component(direction.y, most), component(direction.z, most)};
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length + 0.0, v[1] / length + 0.0, v[2] / length + 0.0};
}

}  // namespace fathom::stages
