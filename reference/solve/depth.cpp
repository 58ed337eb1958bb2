// SPDX-License-Identifier: GPL-3.0-or-later
// The public function: bodies on a narrow lattice are answered there if an expanding polytope can. Otherwise it places the bodies on a
// lattice, or answers for the deciding points if a common lattice would be too fine.
#include "reference/solve/depth.hpp"

#include <utility>

#include "fathom/width.hpp"
#include "kernels/float_environment.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/solve/deciding_points.hpp"

namespace fathom::solve {
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
