// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/solve/methods.hpp"

#include <algorithm>

#include "reference/depth/apart.hpp"
#include "reference/depth/contact.hpp"
#include "reference/depth/naive_depth.hpp"
#include "reference/depth/penetration_depth.hpp"
#include "reference/expanding/expanding_polytope.hpp"

namespace fathom::solve {
namespace {

// Answers by an expanding polytope, which needs no hulls and proves its answer. Returns nullopt if O is not interior or the budget is
// exhausted.
std::optional<Depth> certified_depth(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  const std::size_t budget = expansion_budget(options, pair.a.size() + pair.b.size());
  expanding::Expansion expansion = expanding::nearest_by_expansion(context, pair.a, pair.b, budget, options.workspace);
  if (expansion.end != expanding::ExpansionEnd::proved) return std::nullopt;
  if (options.validate) kernels::insist(expanding::validate(expansion, pair.a, pair.b));
  Penetration answer =
      depth::penetration_along(pair, {expansion.nearest.directions().begin(), expansion.nearest.directions().end()}, options.optima);
  context.counters.expansions = expansion.points;
  context.counters.inner_facets = expansion.inner.facets.size();
  answer.inner = std::move(expansion.inner);
  return Depth{depth::facts_of(pair), std::move(answer), Method::certificate, context.counters};
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

bool expands_first(const Options& options) {
  return options.method == Method::certificate || (options.method == Method::automatic && !options.closest_lines);
}

// Exhausting the usual budget costs about one exact run.
std::size_t expansion_budget(const Options& options, std::size_t input_points) {
  if (options.method == Method::certificate) return expanding::unlimited;
  return options.expansion_budget.value_or(std::min<std::size_t>(200 + 2 * input_points, 20000));
}

Depth exact_depth(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  return depth::penetration_depth(
      context, pair, {options.closest_lines.value_or(ClosestLines::cutting), options.seed, options.optima, options.validate, {}});
}

Depth depth_by_method(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  context.counters = Counters{};
  if (options.method == Method::naive) return naive_depth_of(context, pair, options);
  std::optional<Depth> certified;
  if (expands_first(options)) certified = certified_depth(context, pair, options);
  return certified ? std::move(*certified) : exact_depth(context, pair, options);
}

}  // namespace fathom::solve
