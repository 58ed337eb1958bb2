// SPDX-License-Identifier: GPL-3.0-or-later
// The public function: it places the bodies on a lattice, or answers for the deciding points if a common lattice would be too fine.
#include "fathom/depth.hpp"
#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/solve/deciding_points.hpp"
#include "reference/solve/methods.hpp"

namespace fathom {

Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options) {
  const DefaultFloatEnvironment environment;
  Context context(options.monitor);
  if (const std::optional<PlacedPair> slim = place_if_slim(a, b)) return depth_by_method(context, *slim, options);
  if (std::optional<Depth> depth = depth_by_deciding_points(context, a, b, options)) return std::move(*depth);
  return depth_by_method(context, place(a, b), options);
}

}  // namespace fathom
