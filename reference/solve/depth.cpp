// SPDX-License-Identifier: GPL-3.0-or-later
// The methods, and the choice of one and of the integers that it computes with.

#include "reference/solve/depth.hpp"

#include <algorithm>
#include <utility>

#include "fathom/width.hpp"
#include "kernels/float_environment.hpp"
#include "reference/depth/apart.hpp"
#include "reference/depth/contact.hpp"
#include "reference/depth/naive.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/expanding/expander.hpp"
#include "reference/expanding/expanding_polytope.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/solve/deciding_points.hpp"

namespace fathom::solve {
namespace {

/// Whether an expanding polytope is to be tried first.
bool expands_first(const Options& options) {
  return options.method == Method::certificate || (options.method == Method::automatic && !options.closest_lines);
}

// How many points it may take then. Exhausting the usual budget costs about one exact run.
template <class Bodies>
std::size_t expansion_budget(const Options& options, const Bodies& bodies) {
  if (options.method == Method::certificate) return expanding::unlimited;
  return options.expansion_budget.value_or(std::min<std::size_t>(200 + 2 * (bodies.a.size() + bodies.b.size()), 20000));
}

// The answer that a proved expansion gives, which needs no hulls.
template <class Bodies>
Depth certified_depth(kernels::Context& context, const Bodies& bodies, expanding::Expansion&& expansion,
                      const Options& options) {
  context.counters.expansions = expansion.points;
  context.counters.inner_facets = expansion.inner.facets.size();
  Penetration answer = depth::penetration_along(bodies, expansion.nearest.directions(), options.optima);
  answer.inner = std::move(expansion.inner);
  return {depth::facts_of(bodies), std::move(answer), Method::certificate, context.counters};
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

Depth exact_depth(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  return depth::penetration_depth(
      context, pair,
      {options.closest_lines.value_or(ClosestLines::cutting), options.seed, options.optima, options.validate, {}});
}

}  // namespace

Depth depth_by_method(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  context.counters = Counters{};
  if (options.method == Method::naive) return naive_depth_of(context, pair, options);
  if (!expands_first(options)) return exact_depth(context, pair, options);
  expanding::Expansion expansion =
      expanding::nearest_by_expansion(context, pair.a, pair.b, expansion_budget(options, pair), options.workspace);
  // O is not in the interior, or the budget is exhausted.
  if (expansion.end != expanding::ExpansionEnd::proved) return exact_depth(context, pair, options);
  if (options.validate) kernels::insist(expanding::validate(expansion, pair.a, pair.b));
  return certified_depth(context, pair, std::move(expansion), options);
}

NarrowResult depth_on_narrow_lattice(kernels::Context& context, const polytope::Points& a, const polytope::Points& b,
                                     const Options& options) {
  if (!expands_first(options) || options.validate) return {};
  std::optional<Workspace> own;
  Workspace& workspace = options.workspace != nullptr ? *options.workspace : own.emplace();
  Workspace::Parts& parts = *workspace.parts;
  if (!polytope::place_narrow(a, b, parts.pair)) return {};
  NarrowResult result;
  polytope::with_narrow_bodies(parts.pair, a, b, parts.scan, [&](const auto& bodies) {
    expanding::Expansion expansion =
        expanding::nearest_by_expansion(context, bodies, expansion_budget(options, bodies), &workspace);
    if (expansion.end == expanding::ExpansionEnd::proved)
      result.depth = certified_depth(context, bodies, std::move(expansion), options);
  });
  if (!result.depth) result.pair = polytope::widened(parts.pair, b[0].exact());
  return result;
}

// Bodies on a narrow lattice are answered there if an expanding polytope can, else on the same
// lattice by the exact method. On any other lattice the method decides, or the deciding points
// answer if a common lattice would be too fine.
PlacedDepth placed_depth(kernels::Context& context, const polytope::Points& a, const polytope::Points& b,
                         const Options& options) {
  depth::require_listed(options.optima);
  NarrowResult narrow = depth_on_narrow_lattice(context, a, b, options);
  if (narrow.depth) return {std::move(*narrow.depth), std::nullopt};
  const auto answer = [&](auto method, polytope::PlacedPair pair) {
    Depth depth = method(context, pair, options);
    return PlacedDepth{std::move(depth), std::move(pair)};
  };
  if (narrow.pair) return answer(exact_depth, std::move(*narrow.pair));
  std::vector<Point> room_a, room_b;
  const kernels::Positions exact_a = a.exact(room_a), exact_b = b.exact(room_b);
  if (std::optional<polytope::PlacedPair> slim = polytope::place_if_slim(exact_a, exact_b, &context))
    return answer(depth_by_method, std::move(*slim));
  if (std::optional<Depth> depth = depth_by_deciding_points(context, exact_a, exact_b, options))
    return {std::move(*depth), std::nullopt};
  return answer(depth_by_method, polytope::place(exact_a, exact_b, &context));
}

}  // namespace fathom::solve

namespace fathom {
namespace {

Depth depth_of(const polytope::Points& a, const polytope::Points& b, const Options& options) {
  const kernels::DefaultFloatEnvironment environment;
  kernels::Context context(options.monitor);
  return solve::placed_depth(context, a, b, options).depth;
}

}  // namespace

Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options) {
  return depth_of(a, b, options);
}

Depth penetration_depth(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b,
                        const Options& options) {
  return depth_of(a, b, options);
}

Depth penetration_depth(const Body& a, const Body& b, const Options& options) {
  return depth_of(a.points, b.points, options);
}

// The width is the depth of a body against itself.
Depth width(std::span<const Point> points, const Options& options) { return depth_of(points, points, options); }

}  // namespace fathom
