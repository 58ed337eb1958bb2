// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/depth/apart.hpp"

#include "kernels/number/ratio.hpp"
#include "kernels/parallel.hpp"
#include "kernels/point_algebra.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/distance.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::depth {
namespace {

constexpr std::size_t worth_a_thread = 2048;  // points

// In the direction of the nearest point of P the height is -distance: no shorter translation brings A to B.
Distance distance(kernels::Context& context, const polytope::PlacedPair& pair, bool checked) {
  const polytope::NearestPoints nearest = polytope::nearest_points(pair.a, pair.b);
  if (checked) kernels::insist(polytope::validate(nearest, pair.a.points(), pair.b.points()));
  context.counters.scans += nearest.scans;
  const Vector& n = nearest.normal;
  const mpq_class factor = kernels::ratio(nearest.height, dot(n, n) * pair.denominator);
  return {factor * factor * dot(n, n),
          n,
          factor * n,
          {combination(pair, pair.a.points(), nearest.a), combination(pair, pair.b.points(), nearest.b)},
          contact_of(facing_faces(pair, n))};
}

}  // namespace

BodyFacts facts_of(const polytope::PlacedPair& pair) {
  return {polytope::affine_rank(pair.a.points()) < 3, polytope::affine_rank(pair.b.points()) < 3, 0, 0};
}

bool answer_apart(kernels::Context& context, const polytope::PlacedPair& pair, bool checked, Depth& depth) {
  const polytope::PositionOfOrigin origin = polytope::position_of_origin(pair.a, pair.b);
  if (checked) kernels::insist(polytope::validate(origin, pair.a.points(), pair.b.points()));
  context.counters.scans += origin.scans;
  switch (origin.position) {
    case polytope::Position::inside: return false;
    case polytope::Position::boundary: depth.outcome = Touch{*origin.normal, combination(pair, pair.a.points(), origin.a)}; break;
    case polytope::Position::outside: depth.outcome = distance(context, pair, checked); break;
  }
  return true;
}

Hulls hulls_of(kernels::Context& context, const polytope::PlacedPair& pair, bool checked, BodyFacts& facts) {
  context.report("hulls");
  Hulls hulls;
  const bool one_body = pair.a.points() == pair.b.points();
  kernels::run_both(
      !one_body && pair.a.size() + pair.b.size() >= worth_a_thread, context,
      [&](kernels::Context&) { hulls.a = polytope::convex_hull(pair.a.points()); },
      [&](kernels::Context&) { hulls.b = one_body ? hulls.a : polytope::convex_hull(pair.b.points()); });
  const auto& [a, b] = hulls;
  if (checked) {
    kernels::insist(polytope::validate(a, pair.a.points()));
    kernels::insist(polytope::validate(b, pair.b.points()));
  }
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

}  // namespace fathom::depth
