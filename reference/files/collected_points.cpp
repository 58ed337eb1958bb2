// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/collected_points.hpp"

#include "fathom/numbers.hpp"

namespace fathom::files {

mpq_class exact(Coordinate coordinate) {
  if (const double* const value = std::get_if<double>(&coordinate)) return exact_value(*value);
  return std::get<mpq_class>(std::move(coordinate));
}

void CollectedPoints::add(std::array<Coordinate, 3> point) {
  auto& [x, y, z] = point;
  if (in_binary64_) {
    const double *const u = std::get_if<double>(&x), *const v = std::get_if<double>(&y), *const w = std::get_if<double>(&z);
    if (u && v && w) {
      binary64_.push_back({*u, *v, *w});
      return;
    }
    exact_ = std::move(GivenPoints(std::move(binary64_)).edit());
    in_binary64_ = false;
  }
  exact_.push_back({exact(std::move(x)), exact(std::move(y)), exact(std::move(z))});
}

}  // namespace fathom::files
