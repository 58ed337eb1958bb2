// SPDX-License-Identifier: GPL-3.0-or-later
// On a narrow lattice the few points that make up the contact are the only ones that become rationals.

#include "reference/solve/depth.hpp"

#include <algorithm>
#include <utility>

#include "fathom/width.hpp"
#include "kernels/float_environment.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/solve/deciding_points.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/naive.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/expanding/expander.hpp"
#include "reference/expanding/expanding_polytope.hpp"

namespace fathom::solve {
namespace {

using polytope::NarrowInteger;
using polytope::NarrowPoints;

/// Whether an expanding polytope is to be tried first.
bool expands_first(const Options& options) {
  return options.method == Method::certificate || (options.method == Method::automatic && !options.closest_lines);
}

// How many points it may take then. Exhausting the usual budget costs about one exact run.
std::size_t expansion_budget(const Options& options, std::size_t input_points) {
  if (options.method == Method::certificate) return expanding::unlimited;
  return options.expansion_budget.value_or(std::min<std::size_t>(200 + 2 * input_points, 20000));
}

// The answer that a proved expansion gives, which needs no hulls.
Depth certified(kernels::Context& context, expanding::Expansion&& expansion, Penetration answer, const BodyFacts& facts) {
  context.counters.expansions = expansion.points;
  context.counters.inner_facets = expansion.inner.facets.size();
  answer.inner = std::move(expansion.inner);
  return {facts, std::move(answer), Method::certificate, context.counters};
}

// Returns nullopt if O is not interior or the budget is exhausted.
std::optional<Depth> certified_depth(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  const std::size_t budget = expansion_budget(options, pair.a.size() + pair.b.size());
  expanding::Expansion expansion = expanding::nearest_by_expansion(context, pair.a, pair.b, budget, options.workspace);
  if (expansion.end != expanding::ExpansionEnd::proved) return std::nullopt;
  if (options.validate) kernels::insist(expanding::validate(expansion, pair.a, pair.b));
  Penetration answer = depth::penetration_along(pair, expansion.nearest.directions(), options.optima);
  return certified(context, std::move(expansion), std::move(answer), depth::facts_of(pair));
}

// c / 2^shift.
mpq_class over_power(NarrowInteger c, unsigned shift) {
  mpq_class q;
  if (sgn(c) == 0) return q;
  const unsigned shared = std::min(shift, c.trailing_zeros());
  c.divide_by_power(shared);
  q.get_num() = c.to_mpz();
  q.get_den() <<= shift - shared;
  return q;
}

Point exact(const Point& p) { return p; }
Point exact(const std::array<double, 3>& p) { return polytope::exact_point(p); }

// The contacts of bodies on a narrow lattice. Points is a view of those of a body, as they were given.
template <class Points>
class NarrowContacts {
 public:
  NarrowContacts(Points a, Points b, Workspace::Parts& parts)
      : input_a_(a), input_b_(b), pair_(parts.pair), a_(parts.pair.a), b_(parts.pair.b), memory_(parts.scan) {}

  Optimum optimum(const Vector& n) {
    const Vec3<NarrowInteger> u{NarrowInteger(n.x), NarrowInteger(n.y), NarrowInteger(n.z)};
    std::vector<std::uint32_t> a = face(a_, -u), b = face(b_, u);
    const NarrowInteger height = dot(u, b_[b.front()] - a_[a.front()]);
    const ContactKind kind = depth::kind_of(a.size(), b.size());
    return {n, over_power(height, pair_.shift), {kind, std::move(a), std::move(b)}};
  }

  [[nodiscard]] depth::FaceMeeting meeting(const Optimum& optimum) const {
    const std::vector<std::uint32_t>&of_a = optimum.contact.a, &of_b = optimum.contact.b;
    const auto a = [&](std::size_t k) { return input_a_[of_a[k]]; };
    const auto b = [&](std::size_t k) { return input_b_[of_b[k]]; };
    std::optional<depth::FaceMeeting> simple = depth::simple_meeting(of_a.size(), of_b.size(), a, b);
    if (simple) return std::move(*simple);
    polytope::PlacedPair unit;  // for positions
    unit.denominator <<= pair_.shift;
    unit.origin = exact(input_b_.front());
    return depth::overlap(unit, optimum.direction, {{points(a_, of_a), of_a}, {points(b_, of_b), of_b}});
  }

 private:
  // The corners of the face of a body in direction u.
  std::vector<std::uint32_t> face(const NarrowPoints& body, const Vec3<NarrowInteger>& u) {
    polytope::find_extreme_points(body, u, pair_.exponent, memory_);
    const std::vector<std::uint32_t>& ids = memory_.near;
    if (ids.size() == 1 || (ids.size() == 2 && body[ids[0]] != body[ids[1]])) return ids;
    return depth::face_of(ids, points(body, ids)).ids;
  }

  static std::vector<Vector> points(const NarrowPoints& body, const std::vector<std::uint32_t>& ids) {
    std::vector<Vector> points;
    points.reserve(ids.size());
    for (const std::uint32_t i : ids) points.push_back(expanding::to_vector(body[i]));
    return points;
  }

  Points input_a_, input_b_;
  const polytope::NarrowPair& pair_;
  NarrowPoints a_, b_;
  kernels::ScanMemory& memory_;
};

template <class Points>
NarrowResult solve_narrow(kernels::Context& context, Points a, Points b, const Options& options) {
  if (!expands_first(options) || options.validate) return {};
  std::optional<Workspace> own;
  Workspace& workspace = options.workspace != nullptr ? *options.workspace : own.emplace();
  Workspace::Parts& parts = *workspace.parts;
  if (!polytope::place_narrow(a, b, parts.pair)) return {};
  const std::size_t budget = expansion_budget(options, a.size() + b.size());
  expanding::Expansion expansion = expanding::nearest_by_expansion(context, parts.pair, budget, &workspace);
  if (expansion.end != expanding::ExpansionEnd::proved) return {NarrowEnd::failed, std::nullopt};
  Penetration answer = depth::penetration_by(NarrowContacts<Points>(a, b, parts), expansion.nearest.directions(), options.optima);
  const auto is_flat = [](const polytope::NarrowCloud& cloud) { return polytope::affine_rank(NarrowPoints(cloud)) < 3; };
  const BodyFacts facts{is_flat(parts.pair.a), is_flat(parts.pair.b), 0, 0};
  return {NarrowEnd::answered, certified(context, std::move(expansion), std::move(answer), facts)};
}

Depth naive_depth_of(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  depth::Beginning made{.pair = &pair};
  made.depth.method = Method::naive;
  if (depth::begin(context, made, options.validate)) {
    context.report("hull of all differences");
    const std::vector<Vector> nearest = depth::naive_depth(made.hulls.a.vertices, made.hulls.b.vertices).directions;
    made.depth.outcome = depth::penetration_along(pair, nearest, options.optima);
  }
  made.depth.counters = context.counters;
  return std::move(made.depth);
}

}  // namespace

Depth exact_depth(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  return depth::penetration_depth(
      context, pair, {options.closest_lines.value_or(ClosestLines::cutting), options.seed, options.optima, options.validate, {}});
}

Depth depth_by_method(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  context.counters = Counters{};
  if (options.method == Method::naive) return naive_depth_of(context, pair, options);
  std::optional<Depth> found;
  if (expands_first(options)) found = certified_depth(context, pair, options);
  return found ? std::move(*found) : exact_depth(context, pair, options);
}

NarrowResult depth_on_narrow_lattice(kernels::Context& context, kernels::Positions a, kernels::Positions b, const Options& options) {
  return solve_narrow(context, a, b, options);
}

NarrowResult depth_on_narrow_lattice(kernels::Context& context, std::span<const std::array<double, 3>> a,
                                     std::span<const std::array<double, 3>> b, const Options& options) {
  return solve_narrow(context, a, b, options);
}

// The public function: bodies on a narrow lattice are answered there if an expanding polytope can. Otherwise it places the bodies on a
// lattice, or answers for the deciding points if a common lattice would be too fine.

namespace {

// After an expansion has failed on a narrow lattice, another one would fail too.
PlacedDepth depth_on_any_lattice(kernels::Context& context, kernels::Positions a, kernels::Positions b, const Options& options,
                                 NarrowEnd narrow) {
  const auto answer = [&](polytope::PlacedPair pair) {
    Depth depth = narrow == NarrowEnd::failed ? exact_depth(context, pair, options) : depth_by_method(context, pair, options);
    return PlacedDepth{std::move(depth), std::move(pair)};
  };
  if (std::optional<polytope::PlacedPair> slim = polytope::place_if_slim(a, b)) return answer(std::move(*slim));
  if (std::optional<Depth> depth = depth_by_deciding_points(context, a, b, options)) return {std::move(*depth), std::nullopt};
  return answer(polytope::place(a, b));
}

}  // namespace

PlacedDepth placed_depth(kernels::Context& context, kernels::Positions a, kernels::Positions b, const Options& options) {
  depth::require_listed(options.optima);
  NarrowResult narrow = depth_on_narrow_lattice(context, a, b, options);
  if (narrow.depth) return {std::move(*narrow.depth), std::nullopt};
  return depth_on_any_lattice(context, a, b, options, narrow.end);
}

}  // namespace fathom::solve

namespace fathom {

Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(options.monitor);
  return solve::placed_depth(context, a, b, options).depth;
}

Depth penetration_depth(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b, const Options& options) {
  const kernels::DefaultFloatEnvironment environment;
  depth::require_listed(options.optima);
  kernels::Context context(options.monitor);
  solve::NarrowResult narrow = solve::depth_on_narrow_lattice(context, a, b, options);
  if (narrow.depth) return std::move(*narrow.depth);
  return solve::depth_on_any_lattice(context, polytope::exact_points(a), polytope::exact_points(b), options, narrow.end).depth;
}

Depth penetration_depth(const Body& a, const Body& b, const Options& options) {
  if (a.points.in_binary64() && b.points.in_binary64()) return penetration_depth(a.points.binary64(), b.points.binary64(), options);
  return penetration_depth(a.points.exact(), b.points.exact(), options);
}

// The width is the depth of a body against itself.
Depth width(std::span<const Point> points, const Options& options) { return penetration_depth(points, points, options); }

}  // namespace fathom
