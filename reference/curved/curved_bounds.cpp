// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the bounds: directions that people like, then the nearest point of P, then a
// polytope inside P that grows.
#include "reference/curved/curved_bounds.hpp"

#include <numeric>
#include <optional>
#include <utility>

#include "kernels/float_environment.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/curved/assembly.hpp"
#include "reference/curved/growth.hpp"
#include "reference/curved/lattice.hpp"
#include "reference/curved/oracle.hpp"
#include "reference/expanding/surface.hpp"

namespace fathom::curved {
namespace {

// ---- a half-space and a curved core: one support is the answer, from both sides ----

// The least multiple > 0 of a vector of rationals that is integral and primitive.
mpq_class factor_of(const Point& m) {
  const mpz_class denominator = lcm(lcm(m.x.get_den(), m.y.get_den()), m.z.get_den());
  const mpz_class factor =
      gcd(gcd(mpz_class(m.x * denominator), mpz_class(m.y * denominator)), mpz_class(m.z * denominator));
  mpq_class result(denominator, factor);
  result.canonicalize();
  return result;
}

// The point of a term that reaches its height exactly.
AtomPoint reaching(const Term& term, const Vector& n, const mpq_class& height) {
  TightAtom tight = std::move(tight_atoms(term, n, height).front());
  return {tight.atom, std::move(tight.local)};
}

/// `plane` is the core of A or B; `radius` is that of its shape. `other` is no half-space.
CurvedBounds half_space_bounds(kernels::Context& context, const HalfSpace& plane, const Shape& other, bool plane_is_a,
                               const mpq_class& radius, unsigned bits) {
  const auto& terms = std::get<std::vector<Term>>(other.core);
  const Lattice points = plane_is_a ? lattice({}, terms, bits + 6) : lattice(terms, {}, bits + 6);
  const Goal goal(bits, bits, points.extent * points.unit + 2 * (radius + other.radius), radius + other.radius);
  const mpq_class factor = factor_of(plane.normal);
  const Point& m = plane.normal;
  const Vector outward{mpz_class(m.x * factor), mpz_class(m.y * factor), mpz_class(m.z * factor)};
  CurvedBounds result;
  Vector& n = result.bracket.direction;
  n = plane_is_a ? Vector(-outward) : outward;
  const Vector s = -outward;  // in which the other core is to be seen

  Oracle oracle(context, points, 1);
  oracle.ask(n, points.fine);
  result.support_calls = 1;
  const std::vector<TermHeight> heights = oracle.heights(n);
  InnerPoint inner = oracle.inner_point(0, !plane_is_a);
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (heights[t].exact) inner[t] = reaching(terms[t], s, heights[t].height);

  std::vector<mpq_class> rounded = short_heights(heights, n, goal);
  const mpq_class offset = plane.offset * factor;
  mpq_class low = offset;
  for (std::size_t t = 0; t < terms.size(); ++t) low += dot(s, place(terms[t].atoms[inner[t].atom], inner[t].local));
  const mpq_class lower = signed_square(low, n),
                  upper = signed_square(std::accumulate(rounded.begin(), rounded.end(), offset), n);
  result.low = lower == upper ? goal.exact_or_below(lower) : goal.from_below(lower);
  result.high = lower == upper ? goal.exact_or_above(upper) : goal.from_above(upper);
  (plane_is_a ? result.bracket.heights_b : result.bracket.heights_a) = std::move(rounded);
  (plane_is_a ? result.bracket.inner_b : result.bracket.inner_a) = std::vector<InnerPoint>{std::move(inner)};
  return result;
}

// ---- two curved cores ----

constexpr std::size_t directions_tried = 4;
constexpr unsigned further_bits[] = {80, 160};  // of the extent, where the status is open

// The points' coordinates are multiples of so small a part of the axes that it does not show in the
// bounds.
unsigned fine_for(unsigned bits) { return bits + 6; }

class Search {
 public:
  Search(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits, unsigned status_bits,
         std::size_t budget)
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
      return estimates.perhaps_met(-distance(z), estimates.ceiling(*oracle_.lowest())) &&
             assembly_.met(assembly_.square_of(z));
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

CurvedBounds signed_bounds(kernels::Context& context, const Shape& a, const Shape& b, unsigned bits,
                           std::size_t support_calls) {
  const kernels::DefaultFloatEnvironment environment;
  const auto search = [&](unsigned status_bits, std::size_t budget) {
    if (const auto* plane = std::get_if<HalfSpace>(&a.core))
      return half_space_bounds(context, *plane, b, true, a.radius, status_bits);
    if (const auto* plane = std::get_if<HalfSpace>(&b.core))
      return half_space_bounds(context, *plane, a, false, b.radius, status_bits);
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
