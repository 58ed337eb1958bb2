// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/lattice.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"

namespace fathom::curved {
namespace {

constexpr std::size_t few_points = 16;                       // are looked at one by one
constexpr std::uint64_t most_bits = std::uint64_t{1} << 31;  // of all integers together: 256 MB

template <class F>
void for_each_number(const std::vector<Term>& terms, F f) {
  const auto of_point = [&](const Point& p) { f(p.x), f(p.y), f(p.z); };
  for (const Term& term : terms) {
    for (const Atom& atom : term.atoms) {
      of_point(atom.center);
      std::for_each(atom.axes.begin(), atom.axes.end(), of_point);
    }
  }
}

// The greatest unit of which all numbers are multiples; 1 if all are 0.
mpq_class common_unit(const std::vector<Term>& a, const std::vector<Term>& b) {
  std::uint64_t count = 0;
  for (const std::vector<Term>* terms : {&a, &b}) for_each_number(*terms, [&](const mpq_class&) { ++count; });
  mpz_class numerator = 0, denominator = 1;
  for (const std::vector<Term>* terms : {&a, &b}) {
    for_each_number(*terms, [&](const mpq_class& q) {
      mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), q.get_den_mpz_t());
      mpz_gcd(numerator.get_mpz_t(), numerator.get_mpz_t(), q.get_num_mpz_t());
      if (mpz_sizeinbase(denominator.get_mpz_t(), 2) * count > most_bits)
        throw InputError("input", 0,
                         "the denominators of the shapes' " + std::to_string(count) +
                             " numbers share too little: over a common one all together would pass 256 MB");
    });
  }
  return numerator == 0 ? mpq_class(1) : kernels::ratio(numerator, denominator);
}

class Builder {
 public:
  Builder(const mpq_class& unit, bool negated) : unit_(unit), sign_(negated ? -1 : 1) {}

  LatticeTerm operator()(const Term& term) const {
    LatticeTerm result;
    result.anchor = integers(term.atoms.front().center);
    const auto is_point = [](const Atom& atom) { return atom.axes.empty(); };
    const bool many =
        std::count_if(term.atoms.begin(), term.atoms.end(), is_point) > static_cast<std::ptrdiff_t>(few_points);
    std::vector<Vector> points;
    for (std::uint32_t i = 0; i < term.atoms.size(); ++i) {
      LatticeAtom atom{integers(term.atoms[i].center) - result.anchor, {}, false};
      if (many && is_point(term.atoms[i])) {
        points.push_back(std::move(atom.center));
        result.cloud_names.push_back(i);
        continue;
      }
      for (const Point& axis : term.atoms[i].axes) atom.axes.push_back(integers(axis));
      atom.repeats = !result.atoms.empty() && !atom.axes.empty() && atom.axes == result.atoms.back().axes;
      result.atoms.push_back(std::move(atom));
      result.names.push_back(i);
    }
    if (many) result.cloud = kernels::PointCloud(std::move(points));
    return result;
  }

 private:
  [[nodiscard]] mpz_class integer(const mpq_class& q) const {
    mpz_class factor;  // unit.den / q.den times q.num / unit.num
    mpz_divexact(factor.get_mpz_t(), unit_.get_den_mpz_t(), q.get_den_mpz_t());
    mpz_class result = q.get_num() * factor;
    mpz_divexact(result.get_mpz_t(), result.get_mpz_t(), unit_.get_num_mpz_t());
    return sign_ < 0 ? mpz_class(-result) : result;
  }
  [[nodiscard]] Vector integers(const Point& p) const { return {integer(p.x), integer(p.y), integer(p.z)}; }

  const mpq_class& unit_;
  int sign_;
};

struct Side {
  mpz_class low, high;
  void include(const mpz_class& center, const mpz_class& reach) {
    low = std::min(low, mpz_class(center - reach));
    high = std::max(high, mpz_class(center + reach));
  }
};

// One coordinate of a box around a term, from its anchor, which is the center of an atom.
Side side_of(const LatticeTerm& term, mpz_class Vector::*coordinate) {
  Side side;
  for (const LatticeAtom& atom : term.atoms) {
    mpz_class reach;
    for (const Vector& axis : atom.axes) reach += abs(axis.*coordinate);
    side.include(atom.center.*coordinate, reach);
  }
  for (const Vector& point : term.cloud.points()) side.include(point.*coordinate, 0);
  return side;
}

}  // namespace

std::vector<Vector> points_of(const LatticeTerm& term) {
  std::vector<Vector> result = term.cloud.points();
  for (const LatticeAtom& atom : term.atoms)
    if (atom.axes.empty()) result.push_back(atom.center);
  return result;
}

Lattice lattice(const std::vector<Term>& a, const std::vector<Term>& b, unsigned fine) {
  Lattice result;
  result.unit = common_unit(a, b);
  result.fine = fine;
  result.terms_of_a = a.size();
  std::transform(a.begin(), a.end(), std::back_inserter(result.terms), Builder(result.unit, true));
  std::transform(b.begin(), b.end(), std::back_inserter(result.terms), Builder(result.unit, false));
  for (const LatticeTerm& term : result.terms) result.offset = result.offset + term.anchor;
  mpz_class largest;
  for (mpz_class Vector::*coordinate : {&Vector::x, &Vector::y, &Vector::z}) {
    Side sum{result.offset.*coordinate, result.offset.*coordinate};
    for (const LatticeTerm& term : result.terms) {
      const Side side = side_of(term, coordinate);
      sum.low += side.low;
      sum.high += side.high;
    }
    largest = std::max({largest, mpz_class(abs(sum.low)), mpz_class(abs(sum.high))});
    result.extent = std::max(result.extent, mpz_class(sum.high - sum.low));
  }
  result.exponent = std::max(1L, kernels::bit_length(largest)) + static_cast<long>(fine);
  mpq_div_2exp(result.fine_unit.get_mpq_t(), result.unit.get_mpq_t(), fine);
  return result;
}

}  // namespace fathom::curved
