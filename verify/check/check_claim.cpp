// SPDX-License-Identifier: Apache-2.0
// Which checks belong to which claim.
#include "budget.hpp"
#include "checks.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

/// r is num / den in the user's units; its square root is a length, so in units of 1 / scale it grows by scale^2.
Bound in_units(const Rational& r, const mpz_class& scale) {
  Bound result{r.num.value() * scale * scale, r.den.value()};
  const mpz_class common = gcd(result.num, result.den);
  if (common > 1) {
    result.num /= common;
    result.den /= common;
  }
  return result;
}

void check_numbers(const Certificate& c) {
  if (c.claim == Claim::depth && c.low.num.sign() <= 0) throw refused(c.claim_line, "a depth is positive: the claim is not");
  if (c.claim != Claim::bounds) return;
  if (c.low.num.sign() < 0) throw refused(c.claim_line, "the lower bound is negative");
  if (c.high.num.sign() <= 0) throw refused(c.claim_line, "the upper bound is not positive");
  if (c.low.num.value() * c.high.den.value() > c.high.num.value() * c.low.den.value())
    throw refused(c.claim_line, "the lower bound is above the upper one");
}

void check_counts(const Certificate& c) {
  if (c.a.items.empty()) throw refused(c.a.line, "a has no points");
  if (c.b.items.empty()) throw refused(c.b.line, "b has no points");
  if (c.directions.items.empty()) throw refused(c.directions.line, "there is no direction");
  if (c.claim == Claim::depth) return;
  if (c.directions.items.size() != 1) throw refused(c.directions.line, "this claim takes exactly one direction");
  if (c.all) throw refused(c.directions.line, "'all' goes with a claim of depth alone");
}

}  // namespace

void check_claim(const Certificate& c) {
  check_numbers(c);
  check_counts(c);
  const Scaled bodies = scaled(c);
  const Bound high = in_units(c.high, c.scale);
  check_directions(c, bodies, high);
  switch (c.claim) {
    case Claim::depth: return check_inner(c, bodies, high);
    case Claim::bounds: return check_inner(c, bodies, in_units(c.low, c.scale));
    case Claim::touching: return check_weights(c, bodies);
    case Claim::disjoint: return;
  }
  throw refused(c.claim_line, "an unknown claim");
}

}  // namespace fathom_check
