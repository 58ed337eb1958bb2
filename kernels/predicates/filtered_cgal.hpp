// SPDX-License-Identifier: GPL-3.0-or-later
// Where the interval and the exact tier meet: intervals first, integers when the interval holds zero and more.
#pragma once

#include <CGAL/Filtered_predicate.h>

#include <cstdint>

#include "kernels/predicates/kernels_cgal.hpp"
#include "kernels/predicates/predicates_cgal.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

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

/// The sign of P of the operands [kernels_cgal.hpp]; `interval` and `exact` are P over either kernel, or call it.
template <class Exact, class Approximate, class... Operands>
Sign filtered_sign(const Exact& exact, const Approximate& interval, const Operands&... operands) {
  const CGAL::Filtered_predicate<Exact, Approximate, ToExact, ToIntervals> predicate(exact, interval);
  return sign_of(static_cast<int>(predicate(operands...)));
}

}  // namespace fathom::kernels
