// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/oracle.hpp"

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

namespace {

// n * 2^shift, truncated towards 0.
void shift_towards_zero(mpz_class& n, long shift) {
  if (shift >= 0) mpz_mul_2exp(n.get_mpz_t(), n.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
  else mpz_tdiv_q_2exp(n.get_mpz_t(), n.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
}

// sum += factor * v.
void add_product(Vector& sum, const mpz_class& factor, const Vector& v) {
  mpz_addmul(sum.x.get_mpz_t(), factor.get_mpz_t(), v.x.get_mpz_t());
  mpz_addmul(sum.y.get_mpz_t(), factor.get_mpz_t(), v.y.get_mpz_t());
  mpz_addmul(sum.z.get_mpz_t(), factor.get_mpz_t(), v.z.get_mpz_t());
}

// result = <a,b>.
void set_product(mpz_class& result, const Vector& a, const Vector& b) {
  mpz_mul(result.get_mpz_t(), a.x.get_mpz_t(), b.x.get_mpz_t());
  mpz_addmul(result.get_mpz_t(), a.y.get_mpz_t(), b.y.get_mpz_t());
  mpz_addmul(result.get_mpz_t(), a.z.get_mpz_t(), b.z.get_mpz_t());
}

}  // namespace

int compare(const Ceiling& a, const Ceiling& b) {
  if (sgn(a.height) != sgn(b.height) || sgn(a.height) == 0) return sgn(a.height) - sgn(b.height);
  const int order = cmp(mpz_class(a.height * a.height * dot(b.direction, b.direction)),
                        mpz_class(b.height * b.height * dot(a.direction, a.direction)));
  return sgn(a.height) < 0 ? -order : order;
}

polytope::Difference Oracle::extreme(const Vector& u) {
  return spent() ? polytope::Difference{0, 0} : ask(shortened(u), lattice_.fine);
}

Vector Oracle::shortened(const Vector& n) const {
  const long shift = static_cast<long>(lattice_.fine) + 10 - kernels::bit_length(n);
  Vector result = n;
  if (shift < 0)
    for (mpz_class* c : {&result.x, &result.y, &result.z}) shift_towards_zero(*c, shift);
  return result;
}

polytope::Difference Oracle::ask(const Vector& n, unsigned precision) {
  context_.report("curved bounds");
  PickedPoint result;
  result.picks.resize(lattice_.terms.size());
  result.place = lattice_.offset;
  set_product(height_, n, lattice_.offset);
  shift_towards_zero(height_, lattice_.fine);
  for (std::size_t t = 0; t < lattice_.terms.size(); ++t) {
    const LatticeTerm& term = lattice_.terms[t];
    Pick& pick = result.picks[t];
    find_greatest(term, n);
    height_ += greatest_.height;
    pick.atom = greatest_.atom;
    pick.of_cloud = greatest_.of_cloud;
    result.place = result.place + (pick.of_cloud ? term.cloud[pick.atom] : term.atoms[pick.atom].center);
  }
  for (mpz_class* c : {&result.place.x, &result.place.y, &result.place.z}) shift_towards_zero(*c, lattice_.fine);
  for (std::size_t t = 0; t < lattice_.terms.size(); ++t) {
    Pick& pick = result.picks[t];
    if (pick.of_cloud) continue;
    const LatticeAtom& atom = lattice_.terms[t].atoms[pick.atom];
    set_local(atom, n, precision, pick);
    for (std::size_t k = 0; k < atom.axes.size(); ++k) add_product(result.place, pick.y[k], atom.axes[k]);
  }
  points_.push_back(std::move(result));
  Ceiling ceiling{n, height_};
  if (!lowest_ || compare(ceiling, *lowest_) < 0) lowest_ = std::move(ceiling);
  const auto index = static_cast<std::uint32_t>(points_.size() - 1);
  return {index, index};
}

void Oracle::find_greatest(const LatticeTerm& term, const Vector& n) {
  bool first = true;
  bool exact = true;
  for (std::uint32_t i = 0; i < term.atoms.size(); ++i) {
    const LatticeAtom& atom = term.atoms[i];
    set_product(value_, n, atom.center);
    shift_towards_zero(value_, lattice_.fine);
    if (atom.axes.empty()) {
      exact = true;
    } else {
      if (!atom.repeats) {  // else the root is that of the atom before
        square_ = 0;
        for (const Vector& axis : atom.axes) {
          set_product(rest_, n, axis);
          mpz_addmul(square_.get_mpz_t(), rest_.get_mpz_t(), rest_.get_mpz_t());
        }
        shift_towards_zero(square_, 2L * lattice_.fine);
        mpz_sqrtrem(root_.get_mpz_t(), rest_.get_mpz_t(), square_.get_mpz_t());
        exact = sgn(rest_) == 0;
        if (!exact) ++root_;
      }
      value_ += root_;
    }
    if (first || value_ > greatest_.height) greatest_ = {i, false, value_, exact};
    first = false;
  }
  if (term.cloud.size() == 0) return;
  const std::uint32_t i = kernels::extreme_points(term.cloud, n).front();
  set_product(value_, n, term.cloud[i]);
  shift_towards_zero(value_, lattice_.fine);
  if (first || value_ >= greatest_.height) greatest_ = {i, true, value_, true};
}

void Oracle::set_local(const LatticeAtom& atom, const Vector& n, unsigned precision, Pick& pick) {
  long bits = 0;
  for (std::size_t k = 0; k < atom.axes.size(); ++k) {
    set_product(slope_[k], n, atom.axes[k]);
    bits = std::max(bits, kernels::bit_length(slope_[k]));
  }
  if (bits == 0) return;
  square_ = 0;
  for (std::size_t k = 0; k < atom.axes.size(); ++k) {
    shift_towards_zero(slope_[k], static_cast<long>(precision) + 12 - bits);
    mpz_addmul(square_.get_mpz_t(), slope_[k].get_mpz_t(), slope_[k].get_mpz_t());
  }
  mpz_sqrtrem(root_.get_mpz_t(), rest_.get_mpz_t(), square_.get_mpz_t());
  if (sgn(rest_) != 0) ++root_;
  for (std::size_t k = 0; k < atom.axes.size(); ++k) {
    mpz_class& y = pick.y[k];
    y = slope_[k] << precision;
    mpz_tdiv_q(y.get_mpz_t(), y.get_mpz_t(), root_.get_mpz_t());
    y <<= lattice_.fine - precision;
  }
}

std::vector<TermHeight> Oracle::heights(const Vector& n) {
  std::vector<TermHeight> result;
  for (const LatticeTerm& term : lattice_.terms) {
    find_greatest(term, n);
    mpq_class height(greatest_.height + (dot(n, term.anchor) << lattice_.fine));
    height *= lattice_.fine_unit;
    result.push_back({std::move(height), greatest_.exact});
  }
  return result;
}

AtomPoint Oracle::atom_point(const LatticeTerm& term, const Pick& pick) const {
  if (pick.of_cloud) return {term.cloud_names[pick.atom], {}};
  AtomPoint point{term.names[pick.atom], {}};
  for (std::size_t k = 0; k < term.atoms[pick.atom].axes.size(); ++k) {
    mpq_class y(pick.y[k]);
    mpq_div_2exp(y.get_mpq_t(), y.get_mpq_t(), lattice_.fine);
    point.local.push_back(std::move(y));
  }
  return point;
}

InnerPoint Oracle::inner_point(std::size_t i, bool of_a) const {
  InnerPoint result;
  const std::size_t first = of_a ? 0 : lattice_.terms_of_a, last = of_a ? lattice_.terms_of_a : lattice_.terms.size();
  for (std::size_t t = first; t < last; ++t) result.push_back(atom_point(lattice_.terms[t], points_[i].picks[t]));
  return result;
}

}  // namespace fathom::curved
