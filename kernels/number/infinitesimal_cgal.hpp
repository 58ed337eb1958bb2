// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's traits of the ring of infinitesimals: an integral domain without division, ordered like
// the reals. With them CGAL::Simple_cartesian<Infinitesimal> is a kernel for every construction and
// predicate that does not divide: no intersections.
#pragma once

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/mpz_class.h>

#include <cmath>
#include <limits>
#include <utility>

#include "kernels/number/infinitesimal.hpp"

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
