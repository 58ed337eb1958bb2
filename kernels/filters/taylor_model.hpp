// SPDX-License-Identifier: GPL-3.0-or-later
// Quadratic Taylor models in two variables: a polynomial in floating-point numbers and a radius that holds everything that the polynomial
// leaves out, truncation and rounding alike. Sound in every rounding mode; the constants are derived in proofs/cutting.md.
#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/number/wide_float.hpp"

namespace fathom::kernels {

/// All functions f with |f(s,t) - (c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2)| <= radius for s, t in [-1, 1]. Operations are inclusion
/// isotonic: the result holds f + g, f g, ... for all f, g that the operands hold. Number is double or WideFloat.
template <class Number>
struct TaylorModel {
  std::array<Number, 6> c{};
  double radius = 0;

  /// At least (1 - 7u) |f| for every f held, less the radius, with the u of binary64.
  [[nodiscard]] double linear() const { return size(1) + size(2); }
  [[nodiscard]] double quadratic() const { return size(3) + size(4) + size(5); }
  [[nodiscard]] double norm() const { return size(0) + linear() + quadratic(); }

 private:
  [[nodiscard]] double size(std::size_t i) const { return std::fabs(truncated(c[i])); }
};

namespace taylor {

// Each radius is a sum of fewer than 30 products of non-negative numbers: this makes up for its own rounding, and for underflow.
inline double rounded_up(double radius) { return radius * error_bound::raised_radius + error_bound::underflow; }

// What a product cuts off, rounds, and inherits.
template <class Number>
double radius_of_product(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  const double fl = f.linear(), fq = f.quadratic(), gl = g.linear(), gq = g.quadratic();
  const double fn = std::fabs(truncated(f.c[0])) + fl + fq, gn = std::fabs(truncated(g.c[0])) + gl + gq;
  const double cut_off = fl * gq + fq * gl + fq * gq;
  const double rounding = error_bound::taylor_product<Number> * fn * gn;
  return rounded_up(cut_off + rounding + fn * g.radius + gn * f.radius + f.radius * g.radius);
}

template <class Number>
TaylorModel<Number> operator*(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  return {{f.c[0] * g.c[0], f.c[0] * g.c[1] + f.c[1] * g.c[0], f.c[0] * g.c[2] + f.c[2] * g.c[0],
           f.c[0] * g.c[3] + f.c[3] * g.c[0] + f.c[1] * g.c[1], f.c[0] * g.c[4] + f.c[4] * g.c[0] + f.c[1] * g.c[2] + f.c[2] * g.c[1],
           f.c[0] * g.c[5] + f.c[5] * g.c[0] + f.c[2] * g.c[2]},
          radius_of_product(f, g)};
}

/// The product where f is a model in s alone, and g in t alone.
template <class Number>
TaylorModel<Number> product_of_sides(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  return {{f.c[0] * g.c[0], f.c[1] * g.c[0], f.c[0] * g.c[2], f.c[3] * g.c[0], f.c[1] * g.c[2], f.c[0] * g.c[5]}, radius_of_product(f, g)};
}

/// f plus g, or f minus g: of_pair(x, y) is x + y, or x - y.
template <class Number, class OfPair>
TaylorModel<Number> termwise(const TaylorModel<Number>& f, const TaylorModel<Number>& g, OfPair of_pair) {
  TaylorModel<Number> h;
  for (std::size_t i = 0; i < 6; ++i) h.c[i] = of_pair(f.c[i], g.c[i]);
  h.radius = rounded_up(f.radius + g.radius + error_bound::taylor_sum<Number> * (f.norm() + g.norm()));
  return h;
}
template <class Number>
TaylorModel<Number> operator+(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  return termwise(f, g, std::plus<>());
}
template <class Number>
TaylorModel<Number> operator-(const TaylorModel<Number>& f, const TaylorModel<Number>& g) {
  return termwise(f, g, std::minus<>());
}

/// a f + b g.
template <class Number>
TaylorModel<Number> combination(const Number& a, const TaylorModel<Number>& f, const Number& b, const TaylorModel<Number>& g) {
  TaylorModel<Number> h;
  for (std::size_t i = 0; i < 6; ++i) h.c[i] = a * f.c[i] + b * g.c[i];
  const double of_f = std::fabs(truncated(a)), of_g = std::fabs(truncated(b));
  const double absolute = of_f * f.norm() + of_g * g.norm();
  h.radius = rounded_up(of_f * f.radius + of_g * g.radius + error_bound::taylor_sum<Number> * absolute);
  return h;
}

/// Returns a lower bound, over the whole square, of every function that the model holds. The radius must be finite.
template <class Number>
Number least(const TaylorModel<Number>& f);

extern template double least(const TaylorModel<double>& f);
extern template WideFloat least(const TaylorModel<WideFloat>& f);

}  // namespace taylor
}  // namespace fathom::kernels
