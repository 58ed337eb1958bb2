// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "verify/families/degrade.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

/// The overlap is a share of the distance in the other direction; negative: a gap.
Bodies hair(const Meeting& above, const mpq_class& overlap, Random& random, unsigned n) {
  const Vector direction = random_integer_direction(random, 40);
  const mpq_class thickness = 1 + ratio(random.between(-16, 16), 64);
  const Meeting below = random_meeting(random);
  return lenses({direction, above, below, 0, mpq_class(-thickness), 1, mpq_class(-overlap)}, random, n);
}

mpq_class power_of_ten(long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return power;
}

/// Extents 1, s, 10^-j with s between: 10^-j for a needle, 1 for a plate.
Body stretched_body(Random& random, unsigned n) {
  const Body sphere = random_sphere_body(random, std::max(4u, n));
  const long ratio_exponent = random.between(4, 9), middle = random.between(0, 2);
  const mpq_class between = 1 / power_of_ten(middle == 0 ? ratio_exponent : middle == 1 ? 0 : random.between(1, ratio_exponent - 1));
  return rotated(scaled(sphere, 1, between, mpq_class(1 / power_of_ten(ratio_exponent))), random_rotation(random));
}

}  // namespace

Bodies deep(Random& random, unsigned n) {
  const Body a = random_sphere_body(random, std::max(4u, n)), b = random_sphere_body(random, std::max(4u, n));
  return {a, scaled(b, times_power_of_two(1, -random.between(0, 10)))};
}

Bodies hair_overlap(Random& random, unsigned n) {
  const Meeting above = random_meeting(random);
  const mpq_class overlap = times_power_of_two(1, -random.between(41, 200));
  return hair(above, overlap, random, n);
}

Bodies hair_gap(Random& random, unsigned n) {
  constexpr FeatureKind features[] = {FeatureKind::vertex, FeatureKind::edge, FeatureKind::face};
  const FeatureKind a = features[random.between(0, 2)], b = features[random.between(0, 2)];
  const mpq_class gap = times_power_of_two(1, -random.between(61, 200));
  return hair({a, b}, mpq_class(-gap), random, n);
}

Bodies stretched(Random& random, unsigned n) {
  const Body a = stretched_body(random, n);
  return {a, stretched_body(random, n)};
}

Bodies approaching_degraded(Random& random, unsigned n) {
  const std::span<const DegradationName> ways = degradations();
  const Degradation way = ways[static_cast<std::size_t>(random.between(0, static_cast<std::int64_t>(ways.size()) - 1))].way;
  Bodies generic = random_sphere(random, std::max(4u, n));
  const Case broken = degrade({"", std::move(generic.a), std::move(generic.b)}, way, random.next());
  const auto k = static_cast<unsigned>(random.between(4, 200));
  Case near = approach(broken, k, random.next());
  return {std::move(near.a), std::move(near.b)};
}

}  // namespace fathom::families
