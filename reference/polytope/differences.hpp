// SPDX-License-Identifier: GPL-3.0-or-later
// The implicit vertex set of P = B (+) (-A): all differences b - a of two clouds, at the cost of linear scans.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "kernels/filters/support.hpp"

namespace fathom {

/// The difference b - a, by the indices of a in A and of b in B.
using Difference = std::pair<std::uint32_t, std::uint32_t>;

/// The clouds must outlive it.
struct Differences {
  const PointCloud& a;
  const PointCloud& b;
  std::size_t scans = 0;  ///< linear scans over both clouds so far

  [[nodiscard]] Vector operator[](Difference d) const { return b[d.second] - a[d.first]; }
  /// Returns a difference that maximises <u, p>; of several the one with the lowest indices.
  Difference extreme(const Vector& u);
};

}  // namespace fathom
