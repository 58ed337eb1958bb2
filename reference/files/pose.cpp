// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/pose.hpp"

#include <cmath>

#include "fathom/numbers.hpp"

namespace fathom::files {
namespace {

mpq_class applied(const std::array<mpq_class, 4>& row, const Point& p) {
  return mpq_class(row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3]);
}

bool round_coordinate(mpq_class& value) {
  const double rounded = round_binary64(value, Rounding::rn);
  if (std::isinf(rounded)) return false;
  value = exact_value(rounded);
  return true;
}

}  // namespace

Point placed(const Point& p, const Pose& pose) { return {applied(pose[0], p), applied(pose[1], p), applied(pose[2], p)}; }

bool round_to_binary64(Point& point) { return round_coordinate(point.x) && round_coordinate(point.y) && round_coordinate(point.z); }

}  // namespace fathom::files
