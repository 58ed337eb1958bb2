// SPDX-License-Identifier: GPL-3.0-or-later
// Points of one cloud as they appear with a direction u pointing up: who is higher, and who lies to which side as seen from a third.
// Binary64 first, exact integers when it is unsure.
#pragma once

#include <cstdint>

#include "kernels/filters/support.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// Projects along a generic direction to a plane in which u points up: coordinates (<t,p>, <u,p>) with t = e_i + epsilon e_j, where
/// epsilon is a positive infinitesimal and u, e_i, e_j are linearly independent. So only the null vector projects to 0, and two
/// vectors project to parallel ones only if they are parallel themselves or both level.
class PlanarView {
 public:
  /// u must not be zero; the cloud must outlive the view.
  PlanarView(const PointCloud& cloud, const Vector& u);

  /// The sign of <u, q - p>: positive if q is higher.
  [[nodiscard]] Sign rise(std::uint32_t p, std::uint32_t q) const;
  /// Positive if the way from o to q appears to the left of the way from o to p; zero if they are parallel, or both level.
  [[nodiscard]] Sign turn(std::uint32_t o, std::uint32_t p, std::uint32_t q) const;

 private:
  [[nodiscard]] double height(std::uint32_t p, std::uint32_t q) const;

  const PointCloud* cloud_;
  Vector u_;
  Vec3<double> image_;  // of u
  int right_, far_;     // i and j
};

}  // namespace fathom::kernels
