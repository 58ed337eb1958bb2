// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {
namespace {

// A common denominator with at most this many bits never costs much; a longer one is compared with the coordinates.
constexpr std::size_t short_enough = 4096;
constexpr std::size_t times_the_widest = 8;
// Of all coordinates together, where the denominator outgrows them: 256 MB.
constexpr std::uint64_t most_bits = std::uint64_t{1} << 31;

std::size_t bits(const mpz_class& n) { return mpz_sizeinbase(n.get_mpz_t(), 2); }

/// Until f(coordinate) is false; tells whether it never was.
template <class F>
bool all_coordinates(kernels::Positions a, kernels::Positions b, F f) {
  for (const kernels::Positions body : {a, b}) {
    for (const Point& p : body)
      if (!f(p.x) || !f(p.y) || !f(p.z)) return false;
  }
  return true;
}

/// The most bits that a common denominator in proportion to the coordinates has.
std::size_t in_proportion(kernels::Positions a, kernels::Positions b) {
  std::size_t widest = 0;
  all_coordinates(a, b, [&](const mpq_class& q) {
    widest = std::max({widest, bits(q.get_num()), bits(q.get_den())});
    return true;
  });
  return std::max(short_enough, times_the_widest * widest);
}

/// The common denominator; 0 as soon as more(its bits) is false. Denominators repeat a great deal, so divisibility is asked first.
template <class More>
mpz_class common_denominator(kernels::Positions a, kernels::Positions b, More more) {
  mpz_class common = 1;
  const bool all = all_coordinates(a, b, [&](const mpq_class& q) {
    if (mpz_divisible_p(common.get_mpz_t(), q.get_den_mpz_t())) return true;
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), q.get_den_mpz_t());
    return more(bits(common));
  });
  return all ? common : mpz_class(0);
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

/// The points of both bodies while they are made.
struct Lattice {
  mpz_class denominator = 1;
  Point origin;
  std::vector<Vector> a, b;
};

PlacedPair with_clouds(Lattice lattice) {
  PlacedPair pair = place_integers(std::move(lattice.a), std::move(lattice.b));
  pair.denominator = std::move(lattice.denominator);
  pair.origin = std::move(lattice.origin);
  return pair;
}

std::vector<Vector> shifted_multiples(kernels::Positions body, const mpz_class& denominator, const Vector& origin) {
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

std::vector<Point> offsets(kernels::Positions body, const Point& origin) {
  std::vector<Point> result;
  result.reserve(body.size());
  for (const Point& p : body) result.push_back(p - origin);
  return result;
}

/// For points whose common denominator is much longer than they are: what differences do not need is left out first, and there
/// are limits.
PlacedPair place_wide(kernels::Positions a, kernels::Positions b) {
  Lattice lattice;
  lattice.origin = b.front();
  const std::vector<Point> from_a = offsets(a, lattice.origin), from_b = offsets(b, lattice.origin);
  const std::uint64_t coordinates = 3 * (a.size() + b.size());
  lattice.denominator = common_denominator(from_a, from_b, [&](std::size_t size) { return size * coordinates <= most_bits; });
  if (lattice.denominator == 0) {
    throw InputError("input", 0,
                     "the denominators of the " + std::to_string(a.size() + b.size()) + " points share too little: " +
                         "over a common one all coordinates together would pass " + std::to_string(most_bits >> 23) + " MB");
  }
  for (const Point& p : from_a) lattice.a.push_back(multiple(p, lattice.denominator));
  for (const Point& p : from_b) lattice.b.push_back(multiple(p, lattice.denominator));
  return with_clouds(std::move(lattice));
}

}  // namespace

void require_bodies(kernels::Positions a, kernels::Positions b) {
  if (a.empty() || b.empty()) throw std::invalid_argument("a body needs at least one point");
  all_coordinates(a, b, [](const mpq_class& q) { return kernels::require_lowest_terms(q), true; });
}

std::optional<PlacedPair> place_if_slim(kernels::Positions a, kernels::Positions b) {
  require_bodies(a, b);
  std::size_t limit = short_enough;
  Lattice lattice;
  lattice.denominator = common_denominator(a, b, [&](std::size_t size) {
    if (size > limit && limit == short_enough) limit = in_proportion(a, b);
    return size <= limit;
  });
  if (lattice.denominator == 0) return std::nullopt;
  lattice.origin = b.front();
  const Vector origin = multiple(b.front(), lattice.denominator);
  lattice.a = shifted_multiples(a, lattice.denominator, origin);
  lattice.b = shifted_multiples(b, lattice.denominator, origin);
  coarsen(lattice);
  return with_clouds(std::move(lattice));
}

PlacedPair place(kernels::Positions a, kernels::Positions b) {
  std::optional<PlacedPair> slim = place_if_slim(a, b);
  return slim ? std::move(*slim) : place_wide(a, b);
}

PlacedPair place_integers(std::vector<Vector> a, std::vector<Vector> b) {
  const long exponent = std::max(kernels::binary_exponent(a), kernels::binary_exponent(b));
  PlacedPair pair;
  pair.a = kernels::PointCloud(std::move(a), exponent);
  pair.b = kernels::PointCloud(std::move(b), exponent);
  return pair;
}

Point PlacedPair::position(const Vector& v, const mpz_class& divisor) const {
  const mpz_class unit = denominator * divisor;
  return {origin.x + kernels::ratio(v.x, unit), origin.y + kernels::ratio(v.y, unit), origin.z + kernels::ratio(v.z, unit)};
}

}  // namespace fathom::polytope
