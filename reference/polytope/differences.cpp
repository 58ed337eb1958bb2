// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/polytope/differences.hpp"

namespace fathom {

Difference Differences::extreme(const Vector& u) {
  ++scans;
  if (is_zero(u)) return {0, 0};
  return {extreme_points(a, -u).front(), extreme_points(b, u).front()};
}

}  // namespace fathom
