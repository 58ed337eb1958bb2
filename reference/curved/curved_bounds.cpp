// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/curved_bounds.hpp"

#include <optional>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "reference/curved/assembly.hpp"
#include "reference/curved/directions.hpp"
#include "reference/curved/growth.hpp"
#include "reference/curved/half_space.hpp"
#include "reference/curved/nearest.hpp"
#include "reference/expanding/surface.hpp"

namespace fathom::curved {
namespace {

constexpr std::size_t directions_tried = 4;
constexpr unsigned further_bits[] = {80, 160};  // of the extent, where the status is open

// The points' coordinates are multiples of so small a part of the axes that it does not show in the bounds.
unsigned fine_for(unsigned bits) { return bits + 6; }

class Search {
 public:
  Search(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits, unsigned status_bits, std::size_t budget)
      : a_(std::get<std::vector<Term>>(a.core)),
        b_(std::get<std::vector<Term>>(b.core)),
        lattice_(lattice(a_, b_, fine_for(status_bits))),
        goal_(bits, status_bits, lattice_.extent * lattice_.unit + 2 * (a.radius + b.radius), a.radius + b.radius),
        oracle_(context, lattice_, budget),
        assembly_(context, a_, b_, oracle_, goal_) {}

  CurvedBounds run() {
    ask(likely_directions(lattice_, directions_tried));
    // Cores that a plane separates, or touches, are often nearest where the plane says.
    if (meets()) return assembly_.take();
    search();
    if (assembly_.lower() > 0 || assembly_.closed()) return assembly_.take();
    const Ceiling before = *oracle_.lowest();
    ask(short_directions(lattice_, before.direction));
    if (compare(*oracle_.lowest(), before) < 0) meets();
    return assembly_.take();
  }

 private:
  bool meets() { return oracle_.lowest()->height <= 0 && assembly_.meets_in_face(); }
  // At least one direction is asked for.
  void ask(const std::vector<Vector>& directions) {
    for (const Vector& n : directions)
      if (oracle_.calls() == 0 || !oracle_.spent()) oracle_.ask(n, lattice_.fine);
  }
  void search() {
    const Estimates estimates(lattice_, goal_);
    const auto distance = [&](const polytope::SimplexFoot& z) {
      return estimates.root(dot(z.point, z.point), mpz_class(z.denominator * z.denominator));
    };
    const auto gap = [&](const polytope::SimplexFoot& z) { return estimates.ceiling(*oracle_.lowest()) + distance(z); };
    const auto enough = [&](const polytope::SimplexFoot& z) {
      return estimates.perhaps_met(-distance(z), estimates.ceiling(*oracle_.lowest())) && assembly_.met(assembly_.square_of(z));
    };
    const auto precision = [&](const polytope::SimplexFoot& z) { return estimates.precision(gap(z)); };
    const NearestFoot nearest = find_nearest(oracle_, {0, 0}, enough, precision);
    if (nearest.end == NearestEnd::near || nearest.end == NearestEnd::open) {
      ask_exactly(-nearest.foot.point);
      if (!meets()) assembly_.set_lower(nearest);
      return;
    }
    if (nearest.end == NearestEnd::common) assembly_.set_lower(nearest);
    grow(nearest, estimates);
    if (nearest.end == NearestEnd::common && oracle_.lowest()->height == 0) assembly_.meets_in_face();
  }

  void grow(const NearestFoot& nearest, const Estimates& estimates) {
    Growth growth(oracle_, goal_, estimates, nearest.end == NearestEnd::common);
    if (nearest.end == NearestEnd::inside) {
      const auto& c = nearest.corners;
      growth.start({c[0].ids, c[1].ids, c[2].ids, c[3].ids});
    } else {
      const auto first = expanding::starting_tetrahedron(oracle_);
      if (!first) return;
      growth.start(*first);
    }
    growth.run();
    if (const auto squared = growth.squared()) assembly_.set_lower(*squared, growth.polytope());
  }

  // The normal of a face of the cores may be short.
  void ask_exactly(const Vector& direction) {
    const Vector n = primitive(direction);
    if (kernels::binary_exponent(n) <= most_exact_bits && !oracle_.spent()) oracle_.ask(n, lattice_.fine);
  }

  const std::vector<Term>&a_, &b_;
  Lattice lattice_;
  Goal goal_;
  Oracle oracle_;
  Assembly assembly_;
};

bool open(const CurvedBounds& bounds) { return bounds.low < bounds.high && !Goal::decided(bounds.low, bounds.high); }

}  // namespace

CurvedBounds signed_bounds(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits, std::size_t support_calls) {
  const kernels::DefaultFloatEnvironment environment;
  const auto search = [&](unsigned status_bits, std::size_t budget) {
    if (const auto* plane = std::get_if<HalfSpace>(&a.core)) return half_space_bounds(context, *plane, b, true, a.radius, status_bits);
    if (const auto* plane = std::get_if<HalfSpace>(&b.core)) return half_space_bounds(context, *plane, a, false, b.radius, status_bits);
    return Search(context, a, b, bits, status_bits, budget).run();
  };
  CurvedBounds result = search(bits, support_calls);
  std::size_t calls = result.support_calls;
  for (const unsigned finer : further_bits) {
    if (!open(result) || calls >= support_calls) break;
    if (finer <= bits) continue;
    CurvedBounds next = search(finer, support_calls - calls);
    calls += next.support_calls;
    if (!open(next) || next.high - next.low < result.high - result.low) result = std::move(next);
  }
  result.support_calls = calls;
  return result;
}

}  // namespace fathom::curved
