// SPDX-License-Identifier: Apache-2.0
#include "proved.hpp"

namespace fathom_check {

mpq_class value(const Rational& r) { return {r.num.value(), r.den.value()}; }

mpq_class radii(const Certificate& c) { return value(c.a.radius) + value(c.b.radius); }

bool is_exact(const Certificate& c) {
  return c.claim == Claim::depth || c.claim == Claim::touching || c.claim == Claim::apart;
}

mpq_class squared_of_cores(const Certificate& c) { return c.claim == Claim::apart ? -value(c.low) : value(c.low); }

const char* status(const Certificate& c) {
  const auto of_sign = [](int sign) { return sign > 0 ? "penetrating" : sign < 0 ? "disjoint" : "touching"; };
  switch (c.claim) {
    case Claim::depth:
    case Claim::bounds: return of_sign(1);
    case Claim::disjoint: return of_sign(-1);
    case Claim::touching: return of_sign(sgn(radii(c)));
    case Claim::apart: return of_sign(cmp(radii(c) * radii(c), value(c.low)));
    case Claim::solid: return "solid";
    case Claim::signed_bounds: break;
  }
  if (c.low.num.sign() > 0 || c.high.num.sign() < 0) return of_sign(c.low.num.sign());
  return c.low.num.sign() == 0 && c.high.num.sign() == 0 ? of_sign(0) : "undecided";
}

}  // namespace fathom_check
