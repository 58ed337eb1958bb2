// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "kernels/filters/all_extreme.hpp"
#include "reference/polytope/convexity.hpp"
#include "reference/polytope/hull.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

std::optional<std::size_t> count_inner_points(std::span<const Point> body) {
  if (kernels::all_seen_extreme(body)) return 0;
  const std::optional<PlacedPair> placed = place_if_slim(body, body.first(1));
  if (!placed) return std::nullopt;
  const std::vector<Vector>& points = placed->a.points();
  const Polytope hull = convex_hull(points);
  DistinctPoints extreme = no_points_yet(points, hull.input_ids.size());
  extreme.insert(hull.input_ids.begin(), hull.input_ids.end());
  std::size_t inner = 0;
  for (std::uint32_t i = 0; i < points.size(); ++i) inner += !extreme.contains(i);
  return inner;
}

}  // namespace fathom::polytope
