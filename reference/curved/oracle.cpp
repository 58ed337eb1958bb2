// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/oracle.hpp"

#include <algorithm>
#include <utility>

#include "kernels/vector.hpp"

namespace fathom::curved {
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
