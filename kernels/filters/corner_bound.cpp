// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "kernels/filters/error_bounds.hpp"
#include "kernels/filters/line_filter.hpp"

namespace fathom::kernels {
namespace {

struct Crossing {
  double height, squared_length;
};

Crossing crossing(const Vec3<double>& s, const LineImages& a, std::size_t i, const LineImages& b, std::size_t j) {
  const Vec3<double> w = cross(a.direction(i), b.direction(j));
  return {dot(s, w), dot(w, w)};
}

// The reverse of the proof that a line is farther: 0 <= height' <= H + E bounds the height from above, W - S the length from below.
CornerVerdict verdict(const Crossing& c, const LineBound& bound) {
  const double low = c.height - error_bound::height_over_line;
  if (low > 0 && low * low - bound.above * error_bound::raised_bound * (c.squared_length + error_bound::squared_length) > 0) {
    return CornerVerdict::beyond;
  }
  const double high = c.height + error_bound::height_over_line;
  if (high <= 0) return CornerVerdict::within;
  const double shortest = c.squared_length - error_bound::squared_length;
  if (shortest > 0 && bound.below * error_bound::lowered_bound * shortest - high * high > 0) return CornerVerdict::within;
  return CornerVerdict::unsure;
}

}  // namespace

LineBound line_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  LineBound bound{image_bound(numerator, denominator, exponent), 0};
  // image_bound exceeds the value by less than a part in 2^48, unless it was raised to the least normal number or cut at infinity.
  const bool raised = bound.above <= 2 * std::numeric_limits<double>::min();
  if (std::isfinite(bound.above) && !raised) bound.below = bound.above * error_bound::below_raised;
  return bound;
}

CornerVerdict corners_beyond(const LineImages& rows, const LineImages& columns, const Block& block, const LineBound& bound) {
  const Vec3<double> s = columns.point(block.columns.middle) - rows.point(block.rows.middle);
  CornerVerdict worst = CornerVerdict::beyond;
  for (const std::size_t i : {block.rows.first, block.rows.last}) {
    for (const std::size_t j : {block.columns.first, block.columns.last}) {
      const CornerVerdict corner = verdict(crossing(s, rows, i, columns, j), bound);
      if (corner == CornerVerdict::within) return corner;
      if (corner == CornerVerdict::unsure) worst = corner;
    }
  }
  return worst;
}

double estimated_squared_distance(const LineImages& a, std::size_t i, const LineImages& b, std::size_t j) {
  const Crossing c = crossing(b.point(j) - a.point(i), a, i, b, j);
  return c.height * c.height / c.squared_length;
}

}  // namespace fathom::kernels
