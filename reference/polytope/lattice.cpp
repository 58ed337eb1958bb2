// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/polytope/lattice.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "kernels/number/lowest_terms.hpp"

namespace fathom {
namespace {

/// common := lcm(common, q's denominator). Denominators repeat a great deal, so divisibility is asked first.
void absorb(mpz_class& common, const mpq_class& q) {
  require_lowest_terms(q);
  if (mpz_divisible_p(common.get_mpz_t(), q.get_den_mpz_t())) return;
  mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), q.get_den_mpz_t());
}

mpz_class common_denominator(std::span<const Point> a, std::span<const Point> b) {
  mpz_class common = 1;
  for (const std::span<const Point> body : {a, b}) {
    for (const Point& p : body) {
      absorb(common, p.x);
      absorb(common, p.y);
      absorb(common, p.z);
    }
  }
  return common;
}

/// q * denominator, which the caller knows to be an integer.
mpz_class multiple(const mpq_class& q, const mpz_class& denominator) {
  mpz_class n;
  mpz_divexact(n.get_mpz_t(), denominator.get_mpz_t(), q.get_den_mpz_t());
  n *= q.get_num();
  return n;
}

Vector multiple(const Point& p, const mpz_class& denominator) {
  return {multiple(p.x, denominator), multiple(p.y, denominator), multiple(p.z, denominator)};
}

std::vector<Vector> shifted_multiples(std::span<const Point> body, const mpz_class& denominator, const Vector& origin) {
  std::vector<Vector> result;
  result.reserve(body.size());
  for (const Point& p : body) {
    Vector v = multiple(p, denominator);
    v.x -= origin.x;
    v.y -= origin.y;
    v.z -= origin.z;
    result.push_back(std::move(v));
  }
  return result;
}

template <class F>
void for_each_coordinate(Lattice& lattice, F f) {
  for (std::vector<Vector>* body : {&lattice.a, &lattice.b}) {
    for (Vector& v : *body) {
      f(v.x);
      f(v.y);
      f(v.z);
    }
  }
}

/// Points such as 1/3, 4/3, 7/3 need a denominator, their differences do not: divides out what all coordinates and it share.
void coarsen(Lattice& lattice) {
  mpz_class shared = lattice.denominator;
  for_each_coordinate(lattice, [&](const mpz_class& c) {
    if (shared != 1) mpz_gcd(shared.get_mpz_t(), shared.get_mpz_t(), c.get_mpz_t());
  });
  if (shared == 1) return;
  mpz_divexact(lattice.denominator.get_mpz_t(), lattice.denominator.get_mpz_t(), shared.get_mpz_t());
  for_each_coordinate(lattice, [&](mpz_class& c) { mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), shared.get_mpz_t()); });
}

mpq_class position(const mpq_class& origin, const mpz_class& v, const mpz_class& unit) {
  mpq_class offset(v, unit);
  offset.canonicalize();
  return origin + offset;
}

}  // namespace

Lattice common_lattice(std::span<const Point> a, std::span<const Point> b) {
  if (a.empty() || b.empty()) throw std::invalid_argument("common_lattice: a body without points");
  Lattice lattice;
  lattice.denominator = common_denominator(a, b);
  lattice.origin = b.front();
  const Vector origin = multiple(b.front(), lattice.denominator);
  lattice.a = shifted_multiples(a, lattice.denominator, origin);
  lattice.b = shifted_multiples(b, lattice.denominator, origin);
  coarsen(lattice);
  return lattice;
}

Point position(const Lattice& lattice, const Vector& v, const mpz_class& divisor) {
  const mpz_class unit = lattice.denominator * divisor;
  return {position(lattice.origin.x, v.x, unit), position(lattice.origin.y, v.y, unit), position(lattice.origin.z, v.z, unit)};
}

}  // namespace fathom
