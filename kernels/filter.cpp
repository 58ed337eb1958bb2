// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filter.hpp"

#include <CGAL/Interval_nt.h>

#include <stdexcept>

namespace fathom {
namespace {

using Interval = CGAL::Interval_nt<false>;

Interval interval(const Enclosure& e) { return {e.low, e.high}; }

Vec3<Interval> interval(const Direction& d) {
  const Vec3<Enclosure>& e = d.enclosure();
  return {interval(e.x), interval(e.y), interval(e.z)};
}

// The first two tiers.
template <class Functor, class... Directions>
int decide(const Directions&... directions) {
  TierCounts& counts = predicate_counts()[static_cast<std::size_t>(Functor::id)];
  ++counts.calls;
  {
    // Interval_nt<false> asks its caller to round upward; the guard restores the mode.
    const Interval::Protector upward;
    const Interval r = Functor{}(interval(directions)...);
    if (r.inf() > 0) return 1;
    if (r.sup() < 0) return -1;
    if (r.inf() == 0 && r.sup() == 0) {
      ++counts.zero;
      return 0;
    }
  }
  ++counts.exact;
  const mpz_class r = Functor{}(directions.exact()...);
  if (r == 0) ++counts.zero;
  return sgn(r);
}

// All three. The infinitesimals are let in one after another, from the largest: the terms without e_(k+1), e_(k+2), ... outweigh all
// others, so the first level with a term other than zero decides, and most zeros never see a long polynomial.
template <class Functor, class... Directions>
int perturbed(const Perturbation& p, const Directions&... directions) {
  if (const int sign = decide<Functor>(directions...)) return sign;
  for (unsigned level = 1; level <= infinitesimals; ++level) {
    if (!(p.concerns(directions.role(), level) || ...)) continue;
    const Infinitesimal r = Functor{}(p.moved(directions.exact(), directions.role(), level)...);
    if (const int sign = sgn(r)) {
      ++predicate_counts()[static_cast<std::size_t>(Functor::id)].decided[r.leading().packed()];
      return sign;
    }
  }
  throw std::logic_error("a predicate that no perturbation resolves: " +
                         std::string(predicate_names[static_cast<std::size_t>(Functor::id)]));
}

}  // namespace

int side_of_equator(const Direction& n, const Direction& z) { return decide<SideOfEquator>(n, z); }

int x_order(const Direction& n1, const Direction& n2, const Direction& v) { return decide<XOrder>(n1, n2, v); }

int side_of_arc(const Direction& n, const Direction& d) { return decide<SideOfArc>(n, d); }

int order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n, const Direction& v) {
  return decide<OrderOnVertical>(d1, d2, n, v);
}

int order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z) { return decide<OrderAtInfinity>(d1, d2, z); }

int perturbed_side_of_equator(const Perturbation& p, const Direction& n, const Direction& z) { return perturbed<SideOfEquator>(p, n, z); }

int perturbed_x_order(const Perturbation& p, const Direction& n1, const Direction& n2, const Direction& v) {
  return perturbed<XOrder>(p, n1, n2, v);
}

int perturbed_side_of_arc(const Perturbation& p, const Direction& n, const Direction& d) { return perturbed<SideOfArc>(p, n, d); }

int perturbed_order_on_vertical(const Perturbation& p, const Direction& d1, const Direction& d2, const Direction& n, const Direction& v) {
  return perturbed<OrderOnVertical>(p, d1, d2, n, v);
}

int perturbed_order_at_infinity(const Perturbation& p, const Direction& d1, const Direction& d2, const Direction& z) {
  return perturbed<OrderAtInfinity>(p, d1, d2, z);
}

PredicateCounts& predicate_counts() {
  thread_local PredicateCounts counts{};
  return counts;
}

}  // namespace fathom
