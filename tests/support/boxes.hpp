// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes along the axes, by their corners.
#pragma once

#include <vector>

#include "fathom/point.hpp"

namespace fathom::testing {

inline std::vector<Point> box(const Point& low, const Point& high) {
  std::vector<Point> result;
  for (int i = 0; i < 8; ++i)
    result.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  return result;
}

}  // namespace fathom::testing
