// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filter.hpp"

#include <CGAL/Interval_nt.h>

namespace fathom {
namespace {

using Interval = CGAL::Interval_nt<false>;

Interval interval(const Enclosure& e) { return {e.low, e.high}; }

Vec3<Interval> interval(const Direction& d) {
  const Vec3<Enclosure>& e = d.enclosure();
  return {interval(e.x), interval(e.y), interval(e.z)};
}

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

}  // namespace

int side_of_equator(const Direction& n, const Direction& z) { return decide<SideOfEquator>(n, z); }

int x_order(const Direction& n1, const Direction& n2, const Direction& v) { return decide<XOrder>(n1, n2, v); }

int side_of_arc(const Direction& n, const Direction& d) { return decide<SideOfArc>(n, d); }

int order_on_vertical(const Direction& d1, const Direction& d2, const Direction& n, const Direction& v) {
  return decide<OrderOnVertical>(d1, d2, n, v);
}

int order_at_infinity(const Direction& d1, const Direction& d2, const Direction& z) { return decide<OrderAtInfinity>(d1, d2, z); }

PredicateCounts& predicate_counts() {
  thread_local PredicateCounts counts{};
  return counts;
}

}  // namespace fathom
