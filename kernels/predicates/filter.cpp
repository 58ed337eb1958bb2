// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/predicates/filter.hpp"

#include <CGAL/Interval_nt.h>

#include <stdexcept>
#include <utility>

#include "kernels/filters/double_images.hpp"

namespace fathom {
namespace {

using Interval = CGAL::Interval_nt<false>;

Interval interval(const DoubleInterval& e) { return {e.low, e.high}; }

Vec3<Interval> interval(const Direction& d) {
  const Vec3<DoubleInterval>& e = d.enclosure();
  return {interval(e.x), interval(e.y), interval(e.z)};
}

// The first tier's first try: binary64 on images, in whatever rounding mode. The bounds on the error are derived in
// proofs/kernels.md, "Plain doubles".
constexpr double error_bound(SideOfEquator) { return 0x1p-48; }
constexpr double error_bound(SideOfArc) { return 0x1p-48; }
constexpr double error_bound(XOrder) { return 0x1p-46; }
constexpr double error_bound(OrderAtInfinity) { return 0x1p-46; }
constexpr double error_bound(OrderOnVertical) { return 0x1p-44; }

// Calls that have not been added to predicate_counts() yet: plain numbers, so that counting one costs next to nothing.
constinit thread_local std::array<std::uint64_t, static_cast<std::size_t>(Predicate::count)> new_calls{};

// The first two tiers.
template <class Functor, class... Directions>
int decide(const Directions&... directions) {
  ++new_calls[static_cast<std::size_t>(Functor::id)];
  const double approximate = Functor{}(image(directions)...);
  if (approximate > error_bound(Functor{})) return 1;
  if (approximate < -error_bound(Functor{})) return -1;
  TierCounts& counts = predicate_counts()[static_cast<std::size_t>(Functor::id)];
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

void count_decision(Predicate id, Monomial by) { ++predicate_counts()[static_cast<std::size_t>(id)].decided[by.packed()]; }

// A direction with another in its place if it is the vertical.
const Vector& with_vertical(const Direction& d, const Vector& v) { return d.role() == Role::vertical ? v : d.exact(); }

// All three. The infinitesimals are let in one after another, from the largest: the terms without e_(k+1), e_(k+2), ... outweigh all
// others, so the first level with a term other than zero decides, and most zeros never see a long polynomial. As long as only the
// vertical moves there is no polynomial at all: the predicates are linear in it, and so is it in each infinitesimal.
template <class Functor, class... Directions>
int perturbed(const Perturbation& p, const Directions&... directions) {
  if (const int sign = decide<Functor>(directions...)) return sign;
  bool only_vertical = true;
  for (unsigned level = 1; level <= infinitesimals; ++level) {
    if (!(p.concerns(directions.role(), level) || ...)) continue;
    only_vertical = only_vertical && !((directions.role() != Role::vertical && p.concerns(directions.role(), level)) || ...);
    if (only_vertical) {
      const Vector tilt = p.tilt_of_vertical(level);
      const mpz_class r = Functor{}(with_vertical(directions, tilt)...);
      if (r == 0) continue;
      count_decision(Functor::id, Monomial(level));
      return sgn(r);
    }
    const Infinitesimal r = Functor{}(p.moved(directions.exact(), directions.role(), level)...);
    if (const int sign = sgn(r)) {
      count_decision(Functor::id, r.leading());
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

void count_calls(Predicate id, std::uint64_t calls) { new_calls[static_cast<std::size_t>(id)] += calls; }

PredicateCounts& predicate_counts() {
  thread_local PredicateCounts counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i].calls += std::exchange(new_calls[i], 0);
  return counts;
}

}  // namespace fathom
