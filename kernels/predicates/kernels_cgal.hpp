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
#include <utility>

#include "kernels/number/infinitesimal.hpp"
#include "kernels/predicates/direction.hpp"
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

}  // namespace fathom::kernels
