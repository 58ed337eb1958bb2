// SPDX-License-Identifier: GPL-3.0-or-later
// Weights by Cramer's rule, of which only signs are needed.
#include "reference/unions/multipliers.hpp"

#include <stdexcept>

#include "kernels/vector.hpp"

namespace fathom::unions {
namespace {

bool in_cone(const Vector& u, const Vector& direction) { return is_zero(cross(u, direction)) && dot(u, direction) > 0; }

// For u and v that are not parallel.
bool in_cone(const Vector& u, const Vector& v, const Vector& direction) {
  const Vector n = cross(u, v);
  return dot(n, direction) == 0 && det(direction, v, n) >= 0 && det(u, direction, n) >= 0;
}

bool in_cone(const Vector& u, const Vector& v, const Vector& w, const Vector& direction) {
  const int turn = sgn(det(u, v, w));
  const auto weighs = [&](const mpz_class& minor) { return sgn(minor) * turn >= 0; };
  return turn != 0 && weighs(det(direction, v, w)) && weighs(det(u, direction, w)) && weighs(det(u, v, direction));
}

}  // namespace

std::vector<Barrier> deciding(const std::vector<Barrier>& tight, const Vector& direction) {
  for (const Barrier f : tight)
    if (in_cone(f->normal, direction)) return {f};
  for (std::size_t i = 0; i < tight.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vector &u = tight[i]->normal, &v = tight[j]->normal;
      if (!is_zero(cross(u, v)) && in_cone(u, v, direction)) return {tight[i], tight[j]};
    }
  }
  for (std::size_t i = 0; i < tight.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        if (in_cone(tight[i]->normal, tight[j]->normal, tight[k]->normal, direction)) return {tight[i], tight[j], tight[k]};
  throw std::logic_error("no three barriers hold the nearest point of a cell");
}

}  // namespace fathom::unions
