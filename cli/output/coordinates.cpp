// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/coordinates.hpp"

#include <fmt/format.h>

#include "cli/output/decimal.hpp"
#include "fathom/numbers.hpp"
#include "kernels/vector.hpp"

namespace fathom::cli {
namespace {

std::string decimal(const Surd& value) { return sign(value) < 0 ? "-" + surd_text(negated(value)) : surd_text(value); }

std::string in_full(const Point& p) {
  return fmt::format("({}, {}, {})", exact_text(p.x), exact_text(p.y), exact_text(p.z));
}
std::string in_full(const Vector& n) {
  return fmt::format("({}, {}, {})", n.x.get_str(), n.y.get_str(), n.z.get_str());
}

/// from + length n/|n|.
std::string in_full(const Point& from, const mpq_class& length, const Vector& n) {
  if (const std::optional<Point> point = rational_point(RoundedPoint{from, n, length})) return in_full(*point);
  return fmt::format("{} and {} along {}", in_full(from), exact_text(length), in_full(n));
}

}  // namespace

std::string decimals(const Coordinates& values) {
  return fmt::format("({}, {}, {})", decimal(values[0]), decimal(values[1]), decimal(values[2]));
}

std::string place_text(const Point& p, bool exact) { return exact ? in_full(p) : decimals(coordinates(p)); }

std::string place_text(const AlongNormal& vector, bool exact) {
  const auto& [n, alpha, beta] = vector;
  return exact ? in_full(alpha * n, beta, n) : decimals(coordinates(vector));
}

std::string place_text(const RoundedPoint& point, bool exact) {
  return exact ? in_full(point.core, point.distance, point.normal) : decimals(coordinates(point));
}

std::string way_text(const Vector& n, bool exact) { return exact ? in_full(n) : decimals(unit(n)); }

}  // namespace fathom::cli
