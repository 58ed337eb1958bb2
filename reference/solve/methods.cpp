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

// Exhausting it costs about one exact run.
std::size_t usual_budget(const polytope::PlacedPair& pair) {
  return std::min<std::size_t>(200 + 2 * (pair.a.size() + pair.b.size()), 20000);
}

// Answers by an expanding polytope, which needs no hulls and proves its answer. Returns nullopt if O is not interior or the budget is
// exhausted.
std::optional<Depth> certified_depth(kernels::Context& context, const polytope::PlacedPair& pair, std::size_t budget,
                                     const Options& options) {
  expanding::Expansion expansion = expanding::nearest_by_expansion(context, pair.a, pair.b, budget);
  if (expansion.end != expanding::ExpansionEnd::proved) return std::nullopt;
  if (options.validate) kernels::insist(expanding::validate(expansion, pair.a, pair.b));
  Penetration answer =
      depth::penetration_along(pair, {expansion.nearest.directions().begin(), expansion.nearest.directions().end()}, options.optima);
  context.counters.expansions = expansion.points;
  context.counters.inner_facets = expansion.inner.facets.size();
  answer.inner = std::move(expansion.inner);
  return Depth{depth::facts_of(pair), std::move(answer), Method::certificate, context.counters};
}

Depth exact_depth(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  return depth::penetration_depth(
      context, pair, {options.closest_lines.value_or(ClosestLines::cutting), options.seed, options.optima, options.validate, {}});
}

Depth naive_depth_of(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  Depth depth{depth::facts_of(pair), {}, Method::naive, {}};
  if (!depth::answer_apart(context, pair, options.validate, depth)) {
    const depth::Hulls hulls = depth::hulls_of(context, pair, options.validate, depth);
    context.report("hull of all differences");
    depth.outcome = depth::penetration_along(pair, depth::naive_depth(hulls.a.vertices, hulls.b.vertices).directions, options.optima);
  }
  depth.counters = context.counters;
  return depth;
}

}  // namespace

Depth depth_by_method(kernels::Context& context, const polytope::PlacedPair& pair, const Options& options) {
  context.counters = Counters{};
  std::optional<Depth> certified;
  switch (options.method) {
    case Method::automatic:
      if (!options.closest_lines)
        certified = certified_depth(context, pair, options.expansion_budget.value_or(usual_budget(pair)), options);
      break;
    case Method::certificate: certified = certified_depth(context, pair, expanding::unlimited, options); break;
    case Method::naive: return naive_depth_of(context, pair, options);
    case Method::exact: break;
  }
  return certified ? std::move(*certified) : exact_depth(context, pair, options);
}

}  // namespace fathom::solve
