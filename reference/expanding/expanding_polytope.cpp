// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of the integers: of fixed size where they suffice, else mpz_class.
#include "reference/expanding/expanding_polytope.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/expanding/expander.hpp"

namespace fathom::expanding {
namespace {

using polytope::NarrowDifferences;

void require_clouds(const kernels::PointCloud& a, const kernels::PointCloud& b) {
  if (a.size() == 0 || b.size() == 0) throw std::invalid_argument("an expanding polytope of an empty body");
  for (const kernels::PointCloud* cloud : {&a, &b}) {
    const Vec3<long>& axes = cloud->axis_exponents();
    if (axes != Vec3<long>{a.exponent(), a.exponent(), a.exponent()})
      throw std::invalid_argument("an expanding polytope of clouds that differ in their exponents");
  }
}

// Whether narrow integers hold everything, for coordinates up to 2^w and squared distances to compare with of so many bits.
bool fits(long w, long bits) { return w <= polytope::most_narrow_bits && 6 * w + 20 + bits <= 10 * polytope::most_narrow_bits + 20; }

// Calls f(differences, memory) with integers that hold everything. `bits`: of the squared distances that are compared with, at most.
template <class F>
auto with_integers(const kernels::PointCloud& a, const kernels::PointCloud& b, Workspace::Parts& parts, long bits, F f) {
  require_clouds(a, b);
  if (fits(a.exponent(), bits)) {
    NarrowDifferences differences(a, b, parts.scan);
    return f(differences, parts.narrow);
  }
  polytope::Differences differences{a, b};
  return f(differences, parts.wide);
}

// Of squared distances that the search itself finds.
long own_bits(const kernels::PointCloud& a) { return 4 * a.exponent(); }

long bits_of(const mpq_class& q) {
  return static_cast<long>(std::max(mpz_sizeinbase(q.get_num_mpz_t(), 2), mpz_sizeinbase(q.get_den_mpz_t(), 2)));
}

// Whether h(n)^2 <= squared <n,n>, and h(n) > 0.
bool shows_bound(polytope::Differences& differences, const Vector& n, const mpq_class& squared) {
  if (is_zero(n)) return false;
  const mpz_class h = dot(n, differences[differences.extreme(n)]);
  return h > 0 && h * h * squared.get_den() <= squared.get_num() * dot(n, n);
}

template <class Differences>
Expansion nearest(kernels::Context& context, Differences& differences, Memory<typename Differences::Integer>& memory, std::size_t budget) {
  Expander<Differences> expander(context, differences, memory, budget);
  Expansion result;
  result.end = expander.start() ? expander.find_nearest() : ExpansionEnd::not_inside;
  result.points = expander.points;
  if (result.end != ExpansionEnd::proved) return result;
  result.inner = expander.inner();
  result.nearest = expander.nearest();
  result.sides = expander.sides().calls;
  result.sides_exact = expander.sides().exact;
  return result;
}

template <class Differences>
mpq_class next_nearest(kernels::Context& context, Differences& differences, Memory<typename Differences::Integer>& memory,
                       const mpq_class& nearest, const mpq_class& bound) {
  Expander expander(context, differences, memory, unlimited);
  mpq_class next = bound;
  const ExpansionEnd end = expander.start() ? expander.find_next(nearest, next) : ExpansionEnd::not_inside;
  if (end != ExpansionEnd::proved) throw std::invalid_argument("the next nearest facet is sought of bodies that do not penetrate");
  return next;
}

// The caller's workspace, or one for this call.
class Scratch {
 public:
  explicit Scratch(Workspace* workspace) {
    if (workspace == nullptr) workspace = &own_.emplace();
    parts_ = workspace->parts.get();
  }
  Workspace::Parts& operator*() const { return *parts_; }

 private:
  std::optional<Workspace> own_;
  Workspace::Parts* parts_ = nullptr;
};

}  // namespace

Expansion nearest_by_expansion(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b, std::size_t budget,
                               Workspace* workspace) {
  const Scratch scratch(workspace);
  return with_integers(a, b, *scratch, own_bits(a),
                       [&](auto& differences, auto& memory) { return nearest(context, differences, memory, budget); });
}

Expansion nearest_by_expansion(kernels::Context& context, const polytope::NarrowPair& pair, std::size_t budget, Workspace* workspace) {
  const Scratch scratch(workspace);
  NarrowDifferences differences(pair, (*scratch).scan);
  return nearest(context, differences, (*scratch).narrow, budget);
}

Expansion nearest_by_expansion_in_mpz(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                                      std::size_t budget, Workspace* workspace) {
  const Scratch scratch(workspace);
  require_clouds(a, b);
  polytope::Differences differences{a, b};
  return nearest(context, differences, (*scratch).wide, budget);
}

BallExpansion expand_to_ball(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b, const mpq_class& low,
                             const mpq_class& high, const std::optional<Vector>& hint, std::size_t budget) {
  const Scratch scratch(nullptr);
  return with_integers(a, b, *scratch, bits_of(low), [&]<class Differences>(Differences& differences, auto& memory) {
    Expander<Differences> expander(context, differences, memory, budget);
    BallExpansion result;
    result.end = expander.start() ? expander.fill_ball(low, result.low_holds) : ExpansionEnd::not_inside;
    if (result.end != ExpansionEnd::proved) return result;
    if (result.low_holds) result.inner = expander.inner();
    polytope::Differences exact{a, b};
    const auto shows = [&](const Vector& n) { return shows_bound(exact, n, high); };
    if (hint && shows(*hint)) result.direction = primitive(*hint);
    else result.end = expander.find_direction(shows, result.direction);
    result.high_holds = !is_zero(result.direction);
    return result;
  });
}

mpq_class next_nearest_by_expansion(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                                    const mpq_class& nearest, const mpq_class& bound) {
  const Scratch scratch(nullptr);
  const long bits = std::max(own_bits(a), bits_of(bound));
  return with_integers(a, b, *scratch, bits,
                       [&](auto& differences, auto& memory) { return next_nearest(context, differences, memory, nearest, bound); });
}

std::optional<mpq_class> next_nearest_by_expansion(kernels::Context& context, const polytope::NarrowPair& pair, const mpq_class& nearest,
                                                   const mpq_class& bound, Workspace& workspace) {
  if (!fits(pair.exponent, bits_of(bound))) return std::nullopt;
  NarrowDifferences differences(pair, workspace.parts->scan);
  return next_nearest(context, differences, workspace.parts->narrow, nearest, bound);
}

}  // namespace fathom::expanding
