// SPDX-License-Identifier: Apache-2.0
// Which checks belong to which claim.
#include "budget.hpp"
#include "checks.hpp"
#include "proved.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

/// What the claim says of the cores with this number of it: h(n)/|n|, squared with its sign, in
/// units of 1 / scale.
Bound of_cores(const Certificate& c, const Rational& claimed) {
  mpq_class result = value(claimed);
  if (c.claim == Claim::apart) result = -result;
  if (c.claim == Claim::signed_bounds) {
    result -= radii(c);
    result *= abs(result);
  }
  result *= c.scale * c.scale;
  return {result.get_num(), result.get_den()};
}

void check_numbers(const Certificate& c) {
  if (c.claim == Claim::depth && c.low.num.sign() <= 0)
    throw refused(c.claim_line, "a depth is positive: the claim is not");
  if (c.claim == Claim::apart && c.low.num.sign() <= 0)
    throw refused(c.claim_line, "a distance is positive: the claim is not");
  if (c.claim != Claim::bounds && c.claim != Claim::signed_bounds) return;
  if (c.claim == Claim::bounds && c.low.num.sign() < 0) throw refused(c.claim_line, "the lower bound is negative");
  if (c.claim == Claim::bounds && c.high.num.sign() <= 0)
    throw refused(c.claim_line, "the upper bound is not positive");
  if (c.low.num.value() * c.high.den.value() > c.high.num.value() * c.low.den.value())
    throw refused(c.claim_line, "the lower bound is above the upper one");
}

void check_counts(const Certificate& c) {
  if (c.directions.items.empty()) throw refused(c.directions.line, "there is no direction");
  const bool one = c.claim != Claim::depth || has_half_space(c);
  if (one && c.directions.items.size() != 1) throw refused(c.directions.line, "this claim takes exactly one direction");
  if (one && c.all)
    throw refused(c.directions.line, "'all' goes with a claim of depth alone, and not with a half-space");
}

}  // namespace

void check_claim(const Certificate& c, Arithmetic arithmetic) {
  if (c.claim == Claim::solid) return check_solid(c.a);
  check_numbers(c);
  if (is_of_solids(c)) return check_two_bodies(c, of_cores(c, c.low));
  if (c.format != 3) check_counts(c);
  const Scaled bodies = scaled(c, arithmetic);
  const Bound low = of_cores(c, c.low);
  if (c.format == 3) return check_unions(c, bodies, low);
  check_directions(c, bodies, low, of_cores(c, c.high));
  if (c.proof == Proof::facets) check_inner(c, bodies, low.num > 0 ? low : Bound{0, 1});
  if (c.proof == Proof::weights) check_weights(c, bodies.a.all_points(), bodies.b.all_points(), low);
  if (c.has_cone) check_cone(c, bodies);
  if (c.format == 4) check_patches(c, bodies);
}

}  // namespace fathom_check
