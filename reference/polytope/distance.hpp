// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two finite point sets whose convex hulls have no point in common.
// Output  their exact distance: the point of P = B (+) (-A) nearest to O, as convex weights of both sets.
//         With it the depth becomes one exact signed function of a sweep across contact.                        [proofs/distance.md]
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/filters/support.hpp"
#include "kernels/report.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/position.hpp"

namespace fathom::polytope {

/// The least |b - a|. The nearest point of P is z = (h(n) / <n,n>) n for n = `normal`, as for a penetrating pair, with h(n) < 0.
struct NearestPoints {
  Vector normal;             ///< primitive; -z is a positive multiple of it, and h(normal) / |normal| is -distance
  mpz_class height;          ///< h(normal) < 0. distance^2 = height^2 / <normal,normal>
  std::vector<Weight> a, b;  ///< convex weights of points with sum of weighted b - sum of weighted a = z
  std::size_t scans = 0;     ///< linear scans over all points that it took
};

/// The clouds must have the same exponent and be non-empty, and O must lie outside P. Exact.
/// Throws std::invalid_argument otherwise.
NearestPoints nearest_points(const kernels::PointCloud& a, const kernels::PointCloud& b);

/// Checks the weights and that no point of P is nearer to O, and nothing else. Exact arithmetic only.
[[nodiscard]] kernels::Report validate(const NearestPoints& answer, std::span<const Vector> a, std::span<const Vector> b);

}  // namespace fathom::polytope
