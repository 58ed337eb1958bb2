// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/curved/curved_bounds.hpp"

#include <optional>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/ratio.hpp"
#include "reference/curved/assembly.hpp"
#include "reference/curved/directions.hpp"
#include "reference/curved/growth.hpp"
#include "reference/curved/half_space.hpp"
#include "reference/curved/nearest.hpp"
#include "reference/expanding/start.hpp"

namespace fathom::curved {
namespace {

constexpr std::size_t directions_tried = 4;

// The points' coordinates are multiples of so small a part of the axes that it does not show in the bounds.
unsigned fine_for(unsigned bits) { return bits + 6; }

class Search {
 public:
  Search(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits, std::size_t budget)
      : a_(std::get<std::vector<Term>>(a.core)),
        b_(std::get<std::vector<Term>>(b.core)),
        lattice_(lattice(a_, b_, fine_for(bits))),
        goal_(bits, lattice_.extent * lattice_.unit + 2 * (a.radius + b.radius), a.radius + b.radius),
        oracle_(context, lattice_, budget),
        assembly_(context, a_, b_, oracle_, goal_) {}

  CurvedBounds run() {
    for (const Vector& n : likely_directions(lattice_, directions_tried))
      if (oracle_.calls() == 0 || !oracle_.spent()) oracle_.ask(n, lattice_.fine);
    // Cores that a plane separates, or touches, are often nearest where the plane says.
    if (oracle_.lowest()->height <= 0 && assembly_.meets_in_face()) return assembly_.take();
    search();
    return assembly_.take();
  }

 private:
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
      if (!(oracle_.lowest()->height <= 0 && assembly_.meets_in_face())) assembly_.set_lower(nearest);
      return;
    }
    if (nearest.end == NearestEnd::common) assembly_.set_lower(nearest);
    grow(nearest, estimates);
    if (nearest.end == NearestEnd::common && oracle_.lowest()->height == 0) assembly_.meets_in_face();
  }

  void grow(const NearestFoot& nearest, const Estimates& estimates) {
    Growth growth(oracle_, goal_, estimates);
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

}  // namespace

CurvedBounds signed_bounds(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits, std::size_t support_calls) {
  const kernels::DefaultFloatEnvironment environment;
  if (const auto* plane = std::get_if<HalfSpace>(&a.core)) return half_space_bounds(context, *plane, b, true, a.radius, bits);
  if (const auto* plane = std::get_if<HalfSpace>(&b.core)) return half_space_bounds(context, *plane, a, false, b.radius, bits);
  return Search(context, a, b, bits, support_calls).run();
}

}  // namespace fathom::curved
