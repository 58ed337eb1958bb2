// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {

Difference Differences::extreme(const Vector& u) {
  ++scans;
  if (is_zero(u)) return {0, 0};
  return {kernels::extreme_points(a, -u).front(), kernels::extreme_points(b, u).front()};
}

std::vector<Weight> weights_of(std::span<const Difference> differences, std::span<const mpq_class> weights,
                               std::uint32_t Difference::*side) {
  std::map<std::uint32_t, mpq_class> sums;
  for (std::size_t i = 0; i < differences.size(); ++i) sums[differences[i].*side] += weights[i];
  std::vector<Weight> result;
  for (const auto& [index, weight] : sums) result.push_back({index, weight});
  return result;
}

mpz_class support_naive(std::span<const Vector> a, std::span<const Vector> b, const Vector& u) {
  return dot(u, b[kernels::extreme_points_naive(b, u).front()] - a[kernels::extreme_points_naive(a, -u).front()]);
}

std::optional<Vec3<mpq_class>> convex_combination(std::span<const Vector> points, std::span<const Weight> weights) {
  Vec3<mpq_class> sum;
  mpq_class total;
  for (const Weight& w : weights) {
    if (w.index >= points.size() || w.weight <= 0) return std::nullopt;
    const Vector& p = points[w.index];
    total += w.weight;
    sum.x += w.weight * p.x;
    sum.y += w.weight * p.y;
    sum.z += w.weight * p.z;
  }
  return total == 1 ? std::optional(sum) : std::nullopt;
}

}  // namespace fathom::polytope
