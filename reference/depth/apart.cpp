// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/depth/apart.hpp"

#include "kernels/context.hpp"

namespace fathom::depth {
namespace {

using polytope::Position;

constexpr std::size_t points_worth_a_thread = 2048;

void locate_origin(kernels::Context& context, Beginning& state) {
  state.origin = polytope::position_of_origin(state.pair->a, state.pair->b);
  context.counters.scans += state.origin.scans;
}

void insist_on_origin(const Beginning& state) {
  kernels::insist(polytope::validate(state.origin, state.pair->a.points(), state.pair->b.points()));
}

void find_nearest(kernels::Context& context, Beginning& state) {
  if (state.origin.position != Position::outside) return;
  state.nearest = polytope::nearest_points(state.pair->a, state.pair->b);
  context.counters.scans += state.nearest->scans;
}

void insist_on_nearest(const Beginning& state) {
  if (state.nearest)
    kernels::insist(polytope::validate(*state.nearest, state.pair->a.points(), state.pair->b.points()));
}

void answer(kernels::Context&, Beginning& state) {
  if (state.origin.position == Position::boundary) state.depth.outcome = touch(*state.pair, state.origin);
  if (state.nearest) state.depth.outcome = distance(*state.pair, *state.nearest);
}

void make_hulls(kernels::Context& context, Beginning& state) {
  if (state.origin.position == Position::inside) state.hulls = hulls_of(context, *state.pair, state.depth);
}

void insist_on_made_hulls(const Beginning& state) {
  if (state.origin.position == Position::inside) insist_on_hulls(state.hulls, *state.pair);
}

constexpr Stage<Beginning> until_apart[] = {
    {locate_origin, insist_on_origin}, {find_nearest, insist_on_nearest}, {answer, nullptr}};
constexpr Stage<Beginning> until_hulls[] = {{make_hulls, insist_on_made_hulls}};

}  // namespace

bool begin(kernels::Context& context, Beginning& beginning, bool validate) {
  static_cast<BodyFacts&>(beginning.depth) = facts_of(*beginning.pair);
  run_stages<Beginning>(context, beginning, until_apart, validate);
  run_stages<Beginning>(context, beginning, until_hulls, validate);
  return beginning.origin.position == Position::inside;
}

Hulls hulls_of(kernels::Context& context, const polytope::PlacedPair& pair, BodyFacts& facts) {
  context.report("hulls");
  Hulls hulls;
  const bool one_body = pair.a.points() == pair.b.points();
  kernels::run_both(
      !one_body && pair.a.size() + pair.b.size() >= points_worth_a_thread, context,
      [&](kernels::Context&) { hulls.a = polytope::convex_hull(pair.a.points()); },
      [&](kernels::Context&) { hulls.b = one_body ? hulls.a : polytope::convex_hull(pair.b.points()); });
  const auto& [a, b] = hulls;
  facts.extreme_a = static_cast<std::uint32_t>(a.vertices.size());
  facts.extreme_b = static_cast<std::uint32_t>(b.vertices.size());
  Counters& counters = context.counters;
  counters.vertices_a = a.vertices.size();
  counters.vertices_b = b.vertices.size();
  counters.edges_a = a.edges.size();
  counters.edges_b = b.edges.size();
  counters.facets_a = a.facets.size();
  counters.facets_b = b.facets.size();
  return hulls;
}

void insist_on_hulls(const Hulls& hulls, const polytope::PlacedPair& pair) {
  kernels::insist(polytope::validate(hulls.a, pair.a.points()));
  kernels::insist(polytope::validate(hulls.b, pair.b.points()));
}

}  // namespace fathom::depth
