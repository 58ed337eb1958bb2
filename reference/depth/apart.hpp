// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies on a lattice.
// Output  where O lies, and with it the answer about bodies that do not penetrate; of others the
//         hulls. Every method begins like this. [AGHRS, section 2.2, step before the algorithm]
#pragma once

#include <optional>
#include <span>

#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/number/rational.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::depth {

/// One stage of a method: it makes a part of the state from the parts before it. `insist` throws
/// std::logic_error if a law of that part is broken; it is null where there are none.
template <class State>
struct Stage {
  void (*make)(kernels::Context& context, State& state);
  void (*insist)(const State& state);
};

/// Runs stage after stage. If `validate`, no stage gets what breaks a law.
template <class State>
void run_stages(kernels::Context& context, State& state, std::span<const Stage<State>> stages, bool validate) {
  for (const Stage<State>& stage : stages) {
    stage.make(context, state);
    if (validate && stage.insist != nullptr) stage.insist(state);
  }
}

/// The hulls of both bodies.
struct Hulls {
  polytope::Polytope a, b;
};

/// What every method begins with.
struct Beginning {
  const polytope::PlacedPair* pair = nullptr;  ///< the bodies, which must outlive it
  Depth depth = {};                            ///< of bodies that do not penetrate the answer, except for the counters
  polytope::PositionOfOrigin origin = {};
  std::optional<polytope::NearestPoints> nearest = {};  ///< of bodies that are apart
  Hulls hulls = {};                                     ///< of bodies that penetrate
};

/// Fills in all but `pair` and `depth.method`. Returns whether the bodies penetrate: then
/// `depth.outcome` is still to be found.
[[nodiscard]] bool begin(kernels::Context& context, Beginning& beginning, bool validate);

// The answer about bodies that do not penetrate.

template <class Integer>
Touch touch(const polytope::PlacedPairIn<Integer>& pair, const polytope::PositionOfOrigin& origin) {
  return {*origin.normal, combination(origin.a, [&](std::size_t i) { return pair.point_of_a(i).exact(); })};
}

/// In the direction of the nearest point of P the height is -distance: no shorter translation
/// brings A to B.
template <class Integer>
Distance distance(const polytope::PlacedPairIn<Integer>& pair, const polytope::NearestPoints& nearest) {
  const Vector& n = nearest.normal;
  const mpq_class factor = kernels::ratio(nearest.height, dot(n, n)) * pair.unit();
  return {factor * factor * dot(n, n),
          n,
          factor * n,
          {combination(nearest.a, [&](std::size_t i) { return pair.point_of_a(i).exact(); }),
           combination(nearest.b, [&](std::size_t i) { return pair.point_of_b(i).exact(); })},
          contact_along(pair, n)};
}

/// The whole answer; `outside` if O is known to be outside P. Throws std::invalid_argument if the
/// bodies penetrate.
template <class Integer>
Depth apart_depth(kernels::Context& context, const polytope::PlacedPairIn<Integer>& pair, bool outside) {
  Depth depth;
  depth.method = Method::exact;
  static_cast<BodyFacts&>(depth) = facts_of(pair);
  polytope::PositionOfOrigin origin;
  if (!outside) origin = polytope::position_of_origin(pair.differences());
  context.counters.scans += origin.scans;
  if (origin.position == polytope::Position::boundary) {
    depth.outcome = touch(pair, origin);
  } else {
    const polytope::NearestPoints nearest = polytope::nearest_points(pair.differences());
    context.counters.scans += nearest.scans;
    depth.outcome = distance(pair, nearest);
  }
  depth.counters = context.counters;
  return depth;
}

/// Computes the hulls; sets the counts of extreme points in `facts`, and the counters.
Hulls hulls_of(kernels::Context& context, const polytope::PlacedPair& pair, BodyFacts& facts);
/// Throws std::logic_error if a hull breaks a law.
void insist_on_hulls(const Hulls& hulls, const polytope::PlacedPair& pair);

}  // namespace fathom::depth
