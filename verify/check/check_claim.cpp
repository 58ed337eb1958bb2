// SPDX-License-Identifier: Apache-2.0
// Which checks belong to which claim.
#include "checks.hpp"
#include "limits.hpp"
#include "vectors.hpp"

namespace fathom_check {

namespace {

/// What the claim says of the cores with this number of it: h(n)/|n|, squared with its sign, in
/// units of 2^zeros / scale.
Bound of_cores(const Certificate& c, const Rational& claimed, mp_bitcnt_t zeros = 0) {
  mpq_class result = value(claimed);
  if (c.claim == Claim::apart) result = -result;
  if (c.claim == Claim::signed_bounds) {
    result -= radii(c);
    result *= abs(result);
  }
  result *= c.scale * c.scale;
  result >>= 2 * zeros;
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

/// No way out of the raised bodies that leaves the plane is as short as the depth.
void check_height(const Certificate& c, const Raising& raising) {
  const mpq_class left = value(raising.height) - radii(c);
  if (left <= 0) throw refused(raising.line, "the height is not above the sum of the radii");
  if ((c.claim == Claim::depth || c.claim == Claim::bounds) && value(c.high) >= left * left)
    throw refused(raising.line, "the height is not above the depth");
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
  if (c.format == 6) return check_motions(c, arithmetic);
  check_numbers(c);
  if (c.raising) check_height(c, *c.raising);
  if (is_of_solids(c)) return check_two_bodies(c, of_cores(c, c.low));
  if (c.format != 3) check_counts(c);
  const Scaled bodies = scaled(c, arithmetic);
  const mp_bitcnt_t zeros = bodies.units.largest();
  const Bound low = of_cores(c, c.low, zeros);
  if (c.format == 3) return check_unions(c, bodies, low);
  check_directions(c, bodies, low, of_cores(c, c.high, zeros));
  if (c.proof == Proof::facets) check_inner(c, bodies, low.num > 0 ? low : Bound{0, 1});
  if (c.proof == Proof::weights) check_weights(c, bodies.a.all_points(), bodies.b.all_points(), low);
  if (c.has_cone) check_cone(c, bodies);
  if (c.format == 4) check_patches(c, bodies);
}

// Convex combinations of core points; a point of each core that is given by one: a common point, or
// two that are near to each other.

namespace {

void check_weight(const Weight& w, std::size_t points, std::size_t line) {
  if (w.index >= points) throw refused(line, "there is no point of this number");
  if (w.weight.num.sign() <= 0) throw refused(line, "a weight is positive: this one is not");
}

Combination combine(const Part<std::vector<Weight>>& part, const Points& points) {
  for (std::size_t k = 0; k < part.items.size(); ++k) check_weight(part.items[k], points.size(), part.lines[k]);
  return convex_combination(part.items.data(), part.items.data() + part.items.size(), points, part.line);
}

}  // namespace

Combination convex_combination(const Weight* begin, const Weight* end, const Points& points, std::size_t line) {
  Combination result;
  for (const Weight* w = begin; w != end; ++w) {
    check_weight(*w, points.size(), line);
    mpz_lcm(result.den.get_mpz_t(), result.den.get_mpz_t(), w->weight.den.get_mpz_t());
  }
  mpz_class total = 0, factor;
  for (; begin != end; ++begin) {
    const Weight& w = *begin;
    mpz_divexact(factor.get_mpz_t(), result.den.get_mpz_t(), w.weight.den.get_mpz_t());
    mpz_mul(factor.get_mpz_t(), factor.get_mpz_t(), w.weight.num.get_mpz_t());
    const Vector& p = points[w.index];
    total += factor;
    mpz_addmul(result.sum.x.get_mpz_t(), factor.get_mpz_t(), p.x.get_mpz_t());
    mpz_addmul(result.sum.y.get_mpz_t(), factor.get_mpz_t(), p.y.get_mpz_t());
    mpz_addmul(result.sum.z.get_mpz_t(), factor.get_mpz_t(), p.z.get_mpz_t());
  }
  if (total != result.den) throw refused(line, "these weights do not sum to 1");
  return result;
}

void check_weights(const Certificate& c, const Points& points_a, const Points& points_b, const Bound& low) {
  const Combination a = combine(c.weights_a, points_a), b = combine(c.weights_b, points_b);
  const MutableVector z{b.sum.x * a.den - a.sum.x * b.den, b.sum.y * a.den - a.sum.y * b.den,
                        b.sum.z * a.den - a.sum.z * b.den};
  mpz_class squared;  // times (a.den b.den)^2
  dot(squared, z, z);
  const mpz_class den = a.den * b.den;
  if (squared * low.den <= -low.num * den * den) return;
  const bool common = c.claim == Claim::touching;
  throw refused(c.weights_b.line, common ? "the weights of a and of b yield different points"
                                         : "the weights yield points that are too far apart");
}

mpq_class value(const Rational& r) { return {r.num.value(), r.den.value()}; }

mpq_class radii(const Certificate& c) { return value(c.a.radius) + value(c.b.radius); }

bool is_exact(const Certificate& c) {
  return c.claim == Claim::depth || c.claim == Claim::touching || c.claim == Claim::apart;
}

mpq_class squared_of_cores(const Certificate& c) { return c.claim == Claim::apart ? -value(c.low) : value(c.low); }

const char* status(const Certificate& c) {
  if (c.format == 6) return c.claim == Claim::apart ? "apart" : c.claim == Claim::grazing ? "grazing" : "contact";
  const auto of_sign = [](int sign) { return sign > 0 ? "penetrating" : sign < 0 ? "disjoint" : "touching"; };
  switch (c.claim) {
    case Claim::depth:
    case Claim::bounds: return of_sign(1);
    case Claim::disjoint: return of_sign(-1);
    case Claim::touching: return of_sign(sgn(radii(c)));
    case Claim::apart: return of_sign(cmp(radii(c) * radii(c), value(c.low)));
    case Claim::solid: return "solid";
    case Claim::grazing:
    case Claim::contact:
    case Claim::signed_bounds: break;
  }
  if (c.low.num.sign() > 0 || c.high.num.sign() < 0) return of_sign(c.low.num.sign());
  return c.low.num.sign() == 0 && c.high.num.sign() == 0 ? of_sign(0) : "undecided";
}

}  // namespace fathom_check
