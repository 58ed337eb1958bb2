// SPDX-License-Identifier: GPL-3.0-or-later
// Quadratic Taylor models in two variables: a polynomial in binary64 and a radius that holds everything that the polynomial leaves out,
// truncation and rounding alike. Sound in every rounding mode; the constants are derived in proofs/cutting.md.
#pragma once

#include <array>
#include <cmath>

#include "kernels/filters/error_bounds.hpp"

namespace fathom::kernels {

/// All functions f with |f(s,t) - (c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2)| <= radius for s, t in [-1, 1]. Operations are inclusion
/// isotonic: the result holds f + g, f g, ... for all f, g that the operands hold.
struct TaylorModel {
  std::array<double, 6> c{};
  double radius = 0;

  /// At least (1 - 6u) |f| for every f held, less the radius.
  [[nodiscard]] double linear() const { return std::fabs(c[1]) + std::fabs(c[2]); }
  [[nodiscard]] double quadratic() const { return std::fabs(c[3]) + std::fabs(c[4]) + std::fabs(c[5]); }
  [[nodiscard]] double norm() const { return std::fabs(c[0]) + linear() + quadratic(); }
};

namespace taylor {

// Each radius is a sum of fewer than 30 products of non-negative numbers: this makes up for its own rounding, and for underflow.
inline double rounded_up(double radius) { return radius * error_bound::raised_radius + error_bound::underflow; }

inline TaylorModel operator*(const TaylorModel& f, const TaylorModel& g) {
  TaylorModel h;
  h.c = {f.c[0] * g.c[0],
         f.c[0] * g.c[1] + f.c[1] * g.c[0],
         f.c[0] * g.c[2] + f.c[2] * g.c[0],
         f.c[0] * g.c[3] + f.c[3] * g.c[0] + f.c[1] * g.c[1],
         f.c[0] * g.c[4] + f.c[4] * g.c[0] + f.c[1] * g.c[2] + f.c[2] * g.c[1],
         f.c[0] * g.c[5] + f.c[5] * g.c[0] + f.c[2] * g.c[2]};
  const double fl = f.linear(), fq = f.quadratic(), gl = g.linear(), gq = g.quadratic();
  const double fn = std::fabs(f.c[0]) + fl + fq, gn = std::fabs(g.c[0]) + gl + gq;
  const double truncated = fl * gq + fq * gl + fq * gq;
  const double rounding = error_bound::taylor_product * fn * gn;
  h.radius = rounded_up(truncated + rounding + fn * g.radius + gn * f.radius + f.radius * g.radius);
  return h;
}

/// a f + b g.
inline TaylorModel combination(double a, const TaylorModel& f, double b, const TaylorModel& g) {
  TaylorModel h;
  for (std::size_t i = 0; i < 6; ++i) h.c[i] = a * f.c[i] + b * g.c[i];
  const double absolute = std::fabs(a) * f.norm() + std::fabs(b) * g.norm();
  h.radius = rounded_up(std::fabs(a) * f.radius + std::fabs(b) * g.radius + error_bound::taylor_sum * absolute);
  return h;
}

/// Returns a lower bound, over the whole square, of every function that the model holds.
double least(const TaylorModel& f);

}  // namespace taylor
}  // namespace fathom::kernels
