// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

/// Distances of about |n|, in direction -n larger by the factor 1 + excess.
Lenses plan(const Meeting& above, const Meeting& below, const mpq_class& excess, Random& random) {
  Lenses result{random_integer_direction(random, 40), above, below, {}, {}, {}, {}};
  const mpq_class height = 1 + ratio(random.between(0, 1023), 1024), place = ratio(random.between(-64, 64), 64);
  result.a_bottom = place;
  result.b_top = place + height;
  result.b_bottom = place + ratio(random.between(8, 24), 64);
  result.a_top = result.b_bottom + height * (1 + excess);
  return result;
}

}  // namespace

Bodies inverse(FeatureKind a, FeatureKind b, Random& random, unsigned n) {
  const mpq_class excess = times_power_of_two(1, -random.between(8, 200));
  const Meeting below = random_meeting(random);
  return lenses(plan({a, b}, below, excess, random), random, n);
}

Bodies inverse_tie(Random& random, unsigned n) {
  const Meeting above = random_meeting(random);
  Meeting below = random_meeting(random);
  while (above.a == below.a && above.b == below.b) below = random_meeting(random);
  return lenses(plan(above, below, 0, random), random, n);
}

}  // namespace fathom::families
