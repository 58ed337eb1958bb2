// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernels/filters/error_bounds.hpp"
#include "kernels/filters/line_filter.hpp"
#include "kernels/filters/support.hpp"

namespace fathom::kernels {

WideLine wide_line(const Vector& point, const Vector& direction, long exponent) {
  return {wide_image(point, exponent), wide_image(direction, binary_exponent({&direction, 1}))};
}

const WideLine& WideLines::operator[](std::size_t i) const {
  if (place_.empty()) place_.resize(size_);
  if (place_[i] == 0) {
    made_.push_back(make_(i));
    place_[i] = static_cast<std::uint32_t>(made_.size());
  }
  return made_[place_[i] - 1];
}

WideFloat wide_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
  return WideFloat::scaled(numerator, 2 * exponent) / WideFloat::scaled(denominator, 0) * (1 + WideFloat(8 * WideFloat::unit));
}

// As the filter in binary64, with smaller units.
bool surely_farther(const WideLine& a, const WideLine& b, const WideFloat& bound) {
  const Vec3<WideFloat> w = cross(a.direction, b.direction);
  const WideFloat least = abs(dot(a.point - b.point, w)) - error_bound::height_over_line_of<WideFloat>;
  if (least <= 0) return false;
  const WideFloat raised = bound * (1 + WideFloat(16 * WideFloat::unit));
  return least * least > raised * (dot(w, w) + error_bound::squared_length_of<WideFloat>);
}

}  // namespace fathom::kernels
