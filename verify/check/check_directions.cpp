// SPDX-License-Identifier: Apache-2.0
// Half-spaces that hold P, and how near their planes are to O.
#include <algorithm>

#include "budget.hpp"
#include "checks.hpp"
#include "vectors.hpp"

namespace fathom_check {
namespace {

/// h(n) = max <n,b> - min <n,a>.
mpz_class support(const Scaled& bodies, const Vector& n) {
  mpz_class max_b = dot(n, bodies.b.front()), min_a = dot(n, bodies.a.front());
  for (const Vector& b : bodies.b) max_b = std::max(max_b, dot(n, b));
  for (const Vector& a : bodies.a) min_a = std::min(min_a, dot(n, a));
  return max_b - min_a;
}

/// Whether h^2 compares with squared * <n,n> as the claim demands.
void check_distance(const Certificate& c, const mpz_class& h, const Vector& n, const Rational& squared, std::size_t line) {
  if (h <= 0) throw refused(line, "O does not lie below the plane of this direction");
  const mpz_class reached = h * h * squared.den, allowed = squared.num * dot(n, n);
  if (reached > allowed) throw refused(line, "the boundary of P is farther in this direction than claimed");
  if (c.claim == Claim::depth && reached < allowed) throw refused(line, "the boundary of P is nearer in this direction than claimed");
}

bool ascending(const Vector& u, const Vector& v) {
  if (u.x != v.x) return u.x < v.x;
  return u.y != v.y ? u.y < v.y : u.z < v.z;
}

void check_order(const Part<std::vector<Vector>>& part) {
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    const Vector& n = part.items[k];
    if (gcd(gcd(n.x, n.y), n.z) != 1) throw refused(part.lines[k], "of all directions, each must be primitive");
    if (k > 0 && !ascending(part.items[k - 1], n)) throw refused(part.lines[k], "of all directions, each must be above the one before it");
  }
}

}  // namespace

void check_directions(const Certificate& c, const Scaled& bodies, const Rational& squared) {
  const Part<std::vector<Vector>>& part = c.directions;
  for (std::size_t k = 0; k < part.items.size(); ++k) {
    const Vector& n = part.items[k];
    const std::size_t line = part.lines[k];
    if (is_zero(n)) throw refused(line, "a direction that is zero proves nothing");
    const mpz_class h = support(bodies, n);
    if (c.claim == Claim::touching) {
      if (h != 0) throw refused(line, "O does not lie on the plane of this direction");
    } else if (c.claim == Claim::disjoint) {
      if (h >= 0) throw refused(line, "this direction does not separate the bodies");
    } else {
      check_distance(c, h, n, squared, line);
    }
  }
  if (c.all) check_order(part);
}

}  // namespace fathom_check
