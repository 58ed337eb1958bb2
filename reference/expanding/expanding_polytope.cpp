// SPDX-License-Identifier: GPL-3.0-or-later
// The doors of the search choose its integers: of fixed size where they suffice, else lazy ones.
#include "reference/expanding/expanding_polytope.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "reference/expanding/expander.hpp"

namespace fathom {

Workspace::Workspace() : parts(std::make_unique<Parts>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

}  // namespace fathom

namespace fathom::expanding {
namespace {

void require_clouds(const kernels::PointCloud& a, const kernels::PointCloud& b) {
  if (a.size() == 0 || b.size() == 0) throw std::invalid_argument("an expanding polytope of an empty body");
  for (const kernels::PointCloud* cloud : {&a, &b}) {
    const Vec3<long>& axes = cloud->axis_exponents();
    if (axes != Vec3<long>{a.exponent(), a.exponent(), a.exponent()})
      throw std::invalid_argument("an expanding polytope of clouds that differ in their exponents");
  }
}

// Returns true if narrow integers cannot overflow, for |coordinates| <= 2^w and squared distances
// to compare with of `bits` bits.
bool fits(long w, long bits) {
  return w <= polytope::most_narrow_bits && 6 * w + 20 + bits <= 10 * polytope::most_narrow_bits + 20;
}

// Calls f(differences, memory) with integers that cannot overflow. The squared distances to compare
// with have at most `bits` bits.
template <class F>
auto with_integers(const kernels::PointCloud& a, const kernels::PointCloud& b, Workspace::Parts& parts, long bits,
                   F f) {
  require_clouds(a, b);
  const auto in = [&]<class Integer>(const Integer&) {
    polytope::DifferencesIn<Integer> differences = polytope::differences_in<Integer>(a, b, parts.scan);
    return f(differences, parts.memory<Integer>());
  };
  return fits(a.exponent(), bits) ? polytope::with_integers_for(a.exponent(), in) : in(kernels::LazyInteger());
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
Expansion nearest(kernels::Context& context, Differences& differences, Memory<typename Differences::Integer>& memory,
                  std::size_t budget) {
  const std::uint64_t computed_before = kernels::LazyInteger::computed();
  Expander<Differences> expander(context, differences, memory, budget);
  Expansion result;
  const bool solid = expander.start();
  result.end = solid ? expander.find_nearest() : ExpansionEnd::not_inside;
  result.points = expander.points;
  result.outside = solid && result.end == ExpansionEnd::not_inside && sgn(expander.plane_of_nearest().height) < 0;
  if (result.end != ExpansionEnd::proved) return result;
  result.inner = expander.inner();
  result.nearest = expander.nearest();
  result.sides = expander.sides().calls;
  result.sides_exact = expander.sides().exact;
  result.computed = kernels::LazyInteger::computed() - computed_before;
  return result;
}

template <class Differences>
mpq_class next_nearest(kernels::Context& context, Differences& differences,
                       Memory<typename Differences::Integer>& memory, const mpq_class& nearest,
                       const mpq_class& bound) {
  Expander expander(context, differences, memory, unlimited);
  mpq_class next = bound;
  const ExpansionEnd end = expander.start() ? expander.find_next(nearest, next) : ExpansionEnd::not_inside;
  if (end != ExpansionEnd::proved)
    throw std::invalid_argument("the next nearest facet is sought of bodies that do not penetrate");
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

// The laws of a finished expansion, by definition: every vertex of Q against every facet, all
// points against every direction.
class Check {
 public:
  Check(const Expansion& expansion, const kernels::PointCloud& a, const kernels::PointCloud& b)
      : expansion_(expansion), a_(a), b_(b) {}

  kernels::Report run() {
    if (!report_.expect(expansion_.end == ExpansionEnd::proved && !expansion_.nearest.empty(), "nothing is proved"))
      return report_;
    check_inner_polytope(report_, expansion_.inner, a_, b_, [&](const Vector& n, const mpz_class& height) {
      if (height <= 0) return;
      report_.expect(order(n, height) >= 0, "a facet of Q is nearer than the nearest of P");
      if (order(n, height) == 0) tight_.insert(primitive(n));
    });
    const auto& directions = expansion_.nearest.directions();
    report_.expect(std::equal(tight_.begin(), tight_.end(), directions.begin(), directions.end()),
                   "the nearest facets of Q are not those of P");
    for (const Vector& n : directions) check(n);
    return report_;
  }

 private:
  // The sign of the distance of the plane <n,x> = height, less that of the nearest ones. height >
  // 0.
  [[nodiscard]] int order(const Vector& n, const mpz_class& height) const {
    return cmp(mpz_class(height * height * expansion_.nearest.denominator()),
               mpz_class(expansion_.nearest.numerator() * dot(n, n)));
  }

  void check(const Vector& n) {
    const mpz_class height = dot(n, b_[kernels::extreme_points_naive(b_.points(), n).front()]) -
                             dot(n, a_[kernels::extreme_points_naive(a_.points(), -n).front()]);
    report_.expect(height > 0 && order(n, height) == 0, "a direction is not that of a nearest plane");
  }

  const Expansion& expansion_;
  const kernels::PointCloud& a_;
  const kernels::PointCloud& b_;
  kernels::Report report_;
  std::set<Vector, LexicographicOrder> tight_;
};

}  // namespace

Expansion nearest_by_expansion(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                               std::size_t budget, Workspace* workspace) {
  const Scratch scratch(workspace);
  return with_integers(a, b, *scratch, own_bits(a),
                       [&](auto& differences, auto& memory) { return nearest(context, differences, memory, budget); });
}

template <class Integer>
Expansion nearest_by_expansion(kernels::Context& context, const polytope::PlacedPairIn<Integer>& pair,
                               std::size_t budget, Workspace* workspace) {
  const Scratch scratch(workspace);
  polytope::DifferencesIn<Integer> differences = pair.differences();
  return nearest(context, differences, (*scratch).template memory<Integer>(), budget);
}
template Expansion nearest_by_expansion(kernels::Context&, const polytope::PlacedPairIn<kernels::Integer127>&,
                                        std::size_t, Workspace*);
template Expansion nearest_by_expansion(kernels::Context&, const polytope::PlacedPairIn<kernels::Integer255>&,
                                        std::size_t, Workspace*);
template Expansion nearest_by_expansion(kernels::Context&, const polytope::PlacedPairIn<polytope::NarrowInteger>&,
                                        std::size_t, Workspace*);

template <class Integer>
WarmExpansion nearest_from(kernels::Context& context, const polytope::PlacedPairIn<Integer>& pair, std::size_t budget,
                           Workspace& workspace, std::vector<polytope::Difference>& start, std::size_t most_vertices) {
  polytope::DifferencesIn<Integer> differences = pair.differences();
  Expander expander(context, differences, workspace.parts->memory<Integer>(), budget);
  if (!expander.start(start)) return {ExpansionEnd::not_inside, {}, false};
  WarmExpansion result;
  result.end = expander.find_nearest();
  expander.list_vertices(start, most_vertices);
  result.outside = result.end == ExpansionEnd::not_inside && sgn(expander.plane_of_nearest().height) < 0;
  if (result.end == ExpansionEnd::proved) result.normals = expander.normals_of_nearest();
  return result;
}
template WarmExpansion nearest_from(kernels::Context&, const polytope::PlacedPairIn<kernels::Integer127>&, std::size_t,
                                    Workspace&, std::vector<polytope::Difference>&, std::size_t);
template WarmExpansion nearest_from(kernels::Context&, const polytope::PlacedPairIn<kernels::Integer255>&, std::size_t,
                                    Workspace&, std::vector<polytope::Difference>&, std::size_t);
template WarmExpansion nearest_from(kernels::Context&, const polytope::PlacedPairIn<polytope::NarrowInteger>&,
                                    std::size_t, Workspace&, std::vector<polytope::Difference>&, std::size_t);

template <class Integer>
OriginExpansion locate_origin(kernels::Context& context, const polytope::PlacedPairIn<Integer>& pair,
                              Workspace* workspace, bool with_normal) {
  const Scratch scratch(workspace);
  polytope::DifferencesIn<Integer> differences = pair.differences();
  Expander expander(context, differences, (*scratch).template memory<Integer>(), unlimited);
  OriginExpansion result;
  if (!expander.start()) return {ExpansionEnd::not_inside, 0, {}, {}};
  result.end = expander.find_origin();
  if (result.end == ExpansionEnd::proved) return result;
  result.side = sgn(expander.plane_of_nearest().height);
  if (result.side == 0 || !with_normal) return result;
  result.normal = to_vector(expander.plane_of_nearest().normal);
  result.height = to_mpz(expander.plane_of_nearest().height);
  return result;
}
template OriginExpansion locate_origin(kernels::Context&, const polytope::PlacedPairIn<kernels::Integer127>&,
                                       Workspace*, bool);
template OriginExpansion locate_origin(kernels::Context&, const polytope::PlacedPairIn<kernels::Integer255>&,
                                       Workspace*, bool);
template OriginExpansion locate_origin(kernels::Context&, const polytope::PlacedPairIn<polytope::NarrowInteger>&,
                                       Workspace*, bool);

template <class Integer>
Expansion nearest_by_expansion_in(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                                  std::size_t budget, Workspace* workspace) {
  const Scratch scratch(workspace);
  require_clouds(a, b);
  polytope::DifferencesIn<Integer> differences = polytope::differences_in<Integer>(a, b, (*scratch).scan);
  return nearest(context, differences, (*scratch).template memory<Integer>(), budget);
}
template Expansion nearest_by_expansion_in<kernels::Integer127>(kernels::Context&, const kernels::PointCloud&,
                                                                const kernels::PointCloud&, std::size_t, Workspace*);
template Expansion nearest_by_expansion_in<kernels::Integer255>(kernels::Context&, const kernels::PointCloud&,
                                                                const kernels::PointCloud&, std::size_t, Workspace*);
template Expansion nearest_by_expansion_in<polytope::NarrowInteger>(kernels::Context&, const kernels::PointCloud&,
                                                                    const kernels::PointCloud&, std::size_t,
                                                                    Workspace*);
template Expansion nearest_by_expansion_in<kernels::LazyInteger>(kernels::Context&, const kernels::PointCloud&,
                                                                 const kernels::PointCloud&, std::size_t, Workspace*);
template Expansion nearest_by_expansion_in<mpz_class>(kernels::Context&, const kernels::PointCloud&,
                                                      const kernels::PointCloud&, std::size_t, Workspace*);

BallExpansion expand_to_ball(kernels::Context& context, const kernels::PointCloud& a, const kernels::PointCloud& b,
                             const mpq_class& low, const mpq_class& high, const std::optional<Vector>& hint,
                             std::size_t budget) {
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

std::optional<mpq_class> next_nearest_by_expansion(kernels::Context& context, const polytope::PlacedPair& pair,
                                                   const mpq_class& nearest, const mpq_class& bound,
                                                   Workspace& workspace) {
  const long bits = std::max(own_bits(pair.a), bits_of(bound));
  return with_integers(pair.a, pair.b, *workspace.parts, bits, [&](auto& differences, auto& memory) {
    return next_nearest(context, differences, memory, nearest, bound);
  });
}

std::optional<mpq_class> next_nearest_by_expansion(kernels::Context& context,
                                                   const polytope::PlacedPairIn<polytope::NarrowInteger>& pair,
                                                   const mpq_class& nearest, const mpq_class& bound,
                                                   Workspace& workspace) {
  if (!fits(pair.exponent(), bits_of(bound))) return std::nullopt;
  polytope::DifferencesIn<polytope::NarrowInteger> differences = pair.differences();
  return next_nearest(context, differences, workspace.parts->narrow, nearest, bound);
}

kernels::Report validate(const Expansion& expansion, const kernels::PointCloud& a, const kernels::PointCloud& b) {
  return Check(expansion, a, b).run();
}

}  // namespace fathom::expanding
