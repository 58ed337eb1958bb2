// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {

int affine_rank(const NarrowPoints& points) { return affine_span<NarrowInteger>(points, points.size()).rank; }

void find_extreme_points(const NarrowPoints& body, const Vec3<NarrowInteger>& u, long exponent, kernels::ScanMemory& memory) {
  const kernels::DirectionImage v = kernels::direction_image_for(u, exponent);
  kernels::near_extreme(body.images(), v, memory);
  std::vector<std::uint32_t>& near = memory.near;
  if (near.size() == 1 || v.slack == 0) return;
  std::size_t kept = 0;
  NarrowInteger most;
  for (const std::uint32_t i : near) {
    const NarrowInteger value = dot(u, body[i]);
    const int order = kept == 0 ? 1 : cmp(value, most);
    if (order < 0) continue;
    if (order > 0) {
      kept = 0;
      most = value;
    }
    near[kept++] = i;
  }
  near.resize(kept);
}

Difference NarrowDifferences::extreme(const Vec3<NarrowInteger>& u) {
  if (is_zero(u)) return {0, 0};
  find_extreme_points(a_, -u, exponent_, memory_);
  const std::uint32_t first = memory_.near.front();
  find_extreme_points(b_, u, exponent_, memory_);
  return {first, memory_.near.front()};
}

}  // namespace fathom::polytope
