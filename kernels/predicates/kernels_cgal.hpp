// SPDX-License-Identifier: GPL-3.0-or-later
// The CGAL kernels of the tiers, and the way of an operand into each of them.
//                                                                          [docs/kernel_concept.md]
#pragma once

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Filtered_predicate.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mpz_class.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernels/number/infinitesimal.hpp"
#include "kernels/predicates/direction.hpp"
#include "kernels/predicates/kernels_cgal.hpp"
#include "kernels/predicates/perturbed_kernel.hpp"
#include "kernels/predicates/predicates_cgal.hpp"
#include "kernels/vector.hpp"

// CGAL's traits of the ring of infinitesimals: an integral domain without division, ordered like
// the reals. With them CGAL::Simple_cartesian<Infinitesimal> is a kernel for every construction and
// predicate that does not divide: no intersections.

namespace CGAL {

template <>
class Algebraic_structure_traits<fathom::kernels::Infinitesimal>
    : public Algebraic_structure_traits_base<fathom::kernels::Infinitesimal, Integral_domain_without_division_tag> {
 public:
  using Is_exact = Tag_true;
  using Is_numerical_sensitive = Tag_false;
};

template <>
class Real_embeddable_traits<fathom::kernels::Infinitesimal>
    : public INTERN_RET::Real_embeddable_traits_base<fathom::kernels::Infinitesimal, Tag_true> {
 public:
  struct Sgn : cpp98::unary_function<Type, ::CGAL::Sign> {
    ::CGAL::Sign operator()(const Type& s) const { return CGAL::sign(sgn(s)); }
  };

  struct Compare : cpp98::binary_function<Type, Type, ::CGAL::Comparison_result> {
    ::CGAL::Comparison_result operator()(const Type& s, const Type& t) const { return Sgn{}(s - t); }
    CGAL_IMPLICIT_INTEROPERABLE_BINARY_OPERATOR_WITH_RT(Type, ::CGAL::Comparison_result)
  };

  /// Returns the limit, where all infinitesimals are 0: enough for drawing and messages.
  struct To_double : cpp98::unary_function<Type, double> {
    double operator()(const Type& s) const { return CGAL::to_double(limit(s)); }
  };

  /// Encloses the limit and, if the number differs from it, a neighbourhood.
  struct To_interval : cpp98::unary_function<Type, std::pair<double, double>> {
    std::pair<double, double> operator()(const Type& s) const {
      const auto [low, high] = CGAL::to_interval(limit(s));
      if (s == Type(limit(s))) return {low, high};
      constexpr double inf = std::numeric_limits<double>::infinity();
      return {std::nextafter(low, -inf), std::nextafter(high, inf)};
    }
  };

 private:
  static mpz_class limit(const Type& s) {
    return s.leading() == fathom::kernels::Monomial() && !s.terms().empty() ? s.terms().front().second : mpz_class();
  }
};

}  // namespace CGAL

namespace fathom::kernels {

/// Binary64 without any guarantee: the static filters compare its values with proved error bounds.
using ImageKernel = CGAL::Simple_cartesian<double>;
/// Closed intervals of binary64. Who computes with them rounds upward: CGAL::Filtered_predicate
/// does, or an IntervalKernel::FT::Protector.
using IntervalKernel = CGAL::Simple_cartesian<CGAL::Interval_nt<false>>;
/// GMP integers.
using ExactKernel = CGAL::Simple_cartesian<mpz_class>;
/// Polynomials in the infinitesimals.
using InfinitesimalKernel = CGAL::Simple_cartesian<Infinitesimal>;

/// A vector of a kernel with the components of `v`.
template <class K, class NT>
typename K::Vector_3 to_cgal(const Vec3<NT>& v) {
  return {v.x, v.y, v.z};
}

template <class K>
Vec3<typename K::FT> from_cgal(const CGAL::Vector_3<K>& v) {
  return {v.x(), v.y(), v.z()};
}

inline IntervalKernel::Vector_3 to_intervals(const Vec3<DoubleInterval>& e) {
  using Interval = IntervalKernel::FT;
  return {Interval(e.x.low, e.x.high), Interval(e.y.low, e.y.high), Interval(e.z.low, e.z.high)};
}

/// An operand of a filtered predicate is anything with exact(), a Vector, and enclosure(), a
/// Vec3<DoubleInterval> that holds a positive multiple of it.
struct ToExact {
  template <class Operand>
  ExactKernel::Vector_3 operator()(const Operand& operand) const {
    return to_cgal<ExactKernel>(operand.exact());
  }
};

struct ToIntervals {
  template <class Operand>
  IntervalKernel::Vector_3 operator()(const Operand& operand) const {
    return to_intervals(operand.enclosure());
  }
};

// Where both meet: intervals first, integers when the interval holds zero and more.

/// The exact tier of a predicate, counted.
template <class P>
struct Counted {
  using result_type = typename P::result_type;
  std::uint64_t* calls;

  template <class... Vectors>
  result_type operator()(const Vectors&... vectors) const {
    ++*calls;
    return P{}(vectors...);
  }
};

/// The sign of P of the operands; `interval` and `exact` are P over either kernel, or call it.
template <class Exact, class Approximate, class... Operands>
Sign filtered_sign(const Exact& exact, const Approximate& interval, const Operands&... operands) {
  const CGAL::Filtered_predicate<Exact, Approximate, ToExact, ToIntervals> predicate(exact, interval);
  return sign_of(static_cast<int>(predicate(operands...)));
}

// Where all tiers meet: doubles with a proved bound on the error, then intervals; exact integers
// when the interval holds zero; infinitesimals only when the exact sign is zero.

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
