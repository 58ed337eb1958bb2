// SPDX-License-Identifier: GPL-3.0-or-later
// Lines in wide floats, for near ties: a filter between the one in binary64 and exact arithmetic, and what wide frames are made of.
// [proofs/closest_lines.md, "Wide filter"]
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "kernels/number/wide_float.hpp"

namespace fathom::kernels {

/// A line scaled as those of LineImages are: the point by 2^-exponent into [-1, 1], the direction by a power of two of its own so that the
/// largest component lies in [1/2, 1]; either is within 2^-120 a coordinate.
struct WideLine {
  Vec3<WideFloat> point, direction;

  void reverse() { direction = -direction; }
};

/// |coordinates of point| <= 2^exponent; direction not zero.
WideLine wide_line(const Vector& point, const Vector& direction, long exponent);

/// Lines that are made when they are first asked for: seldom are all of them. Not to be shared between threads.
class WideLines {
 public:
  using Number = WideFloat;
  using Make = std::function<WideLine(std::size_t)>;

  WideLines(std::size_t size, Make make) : size_(size), make_(std::move(make)) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const WideLine& operator[](std::size_t i) const;
  [[nodiscard]] const Vec3<WideFloat>& point(std::size_t i) const { return (*this)[i].point; }
  [[nodiscard]] const Vec3<WideFloat>& direction(std::size_t i) const { return (*this)[i].direction; }

 private:
  std::size_t size_;
  Make make_;
  mutable std::vector<std::uint32_t> place_;  // one more than the index among those made, or 0; empty before the first
  mutable std::deque<WideLine> made_;         // which stay where they are
};

/// An upper bound of numerator/denominator * 4^-exponent, which is >= 0: by less than a part in 2^113.
WideFloat wide_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent);

/// True only if the lines are not parallel and their squared distance exceeds `bound` strictly. `bound` is a squared distance in images,
/// >= 0, as from wide_bound. Both lines must have the same exponent.
bool surely_farther(const WideLine& a, const WideLine& b, const WideFloat& bound);

}  // namespace fathom::kernels
