// SPDX-License-Identifier: GPL-3.0-or-later
// The public function: it places the bodies on a lattice, or answers for the deciding points if a common lattice would be too fine.
#include "fathom/depth.hpp"

#include "kernels/context.hpp"
#include "kernels/float_environment.hpp"
#include "reference/depth/contact.hpp"
#include "reference/polytope/placed_pair.hpp"
#include "reference/solve/deciding_points.hpp"
#include "reference/solve/methods.hpp"

namespace fathom {

Depth penetration_depth(std::span<const Point> a, std::span<const Point> b, const Options& options) {
  const kernels::DefaultFloatEnvironment environment;
  depth::require_listed(options.optima);
  kernels::Context context(options.monitor);
  if (const std::optional<polytope::PlacedPair> slim = polytope::place_if_slim(a, b))
    return solve::depth_by_method(context, *slim, options);
  if (std::optional<Depth> depth = solve::depth_by_deciding_points(context, a, b, options)) return std::move(*depth);
  return solve::depth_by_method(context, polytope::place(a, b), options);
}

}  // namespace fathom
