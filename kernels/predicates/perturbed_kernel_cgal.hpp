// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tiers meet: doubles with a proved bound on the error, then intervals; exact integers
// when the interval holds zero; infinitesimals only when the exact sign is zero.
#pragma once

#include <stdexcept>
#include <string>

#include "kernels/predicates/direction.hpp"
#include "kernels/predicates/kernels_cgal.hpp"
#include "kernels/predicates/perturbed_kernel.hpp"

namespace fathom::kernels {

// Returns v if d is the vertical, else d.
inline ExactKernel::Vector_3 with_vertical(const Direction& d, const Vector& v) {
  return to_cgal<ExactKernel>(d.role() == Role::vertical ? v : d.exact());
}

// The first three tiers.
template <template <class> class P, class... Directions>
Sign UnperturbedKernel::decide(const Directions&... directions) const {
  TierCounts& counts = (*counts_)[static_cast<std::size_t>(P<ExactKernel>::id)];
  ++counts.calls;
  const double approximate = P<ImageKernel>::value(to_cgal<ImageKernel>(image(directions))...);
  if (const auto sure = sure_sign(approximate, P<ImageKernel>::error)) return *sure;
  const Sign sign = filtered_sign(Counted<P<ExactKernel>>{&counts.exact}, P<IntervalKernel>{}, directions...);
  if (sign == Sign::zero) ++counts.zero;
  return sign;
}

// All four. The infinitesimals are let in one after another, from the largest: the terms without
// e_(k+1), e_(k+2), ... outweigh all others, so the first level with a term other than zero
// decides, and most zeros never see a long polynomial. As long as only the vertical moves there is
// no polynomial at all: the predicates are linear in it, and so is it in each infinitesimal.
template <template <class> class P, class... Directions>
Sign PerturbedKernel::decide(const Directions&... directions) const {
  if (const Sign sign = unperturbed_.decide<P>(directions...); sign != Sign::zero) return sign;
  const Perturbation& p = *perturbation_;
  constexpr auto id = static_cast<std::size_t>(P<ExactKernel>::id);
  const auto count_decision = [&](Monomial by) { ++(*unperturbed_.counts_)[id].decided[by.packed()]; };
  bool only_vertical = true;
  for (unsigned level = 1; level <= infinitesimals; ++level) {
    if (!(p.concerns(directions.role(), level) || ...)) continue;
    only_vertical =
        only_vertical && !((directions.role() != Role::vertical && p.concerns(directions.role(), level)) || ...);
    if (only_vertical) {
      const Vector tilt = p.tilt_of_vertical(level);
      const mpz_class r = P<ExactKernel>::value(with_vertical(directions, tilt)...);
      if (r == 0) continue;
      count_decision(Monomial(level));
      return sign_of(r);
    }
    const Infinitesimal r = P<InfinitesimalKernel>::value(
        to_cgal<InfinitesimalKernel>(p.moved(directions.exact(), directions.role(), level))...);
    if (const int sign = sgn(r)) {
      count_decision(r.leading());
      return sign_of(sign);
    }
  }
  throw std::logic_error("a predicate that no perturbation resolves: " + std::string(predicate_names[id]));
}

}  // namespace fathom::kernels
