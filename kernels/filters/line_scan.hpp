// SPDX-License-Identifier: GPL-3.0-or-later
// The floating-point filter of the closest-lines scans: throws out, in a few nanoseconds, pairs of lines that are proved to be farther
// apart than a bound. Whatever it is unsure of it returns, for exact arithmetic to decide. It is sound in every rounding mode; the error
// bounds are derived in proofs/closest_lines.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/vector.hpp"

namespace fathom::kernels {

/// Binary64 images of lines, one array per coordinate. Points are scaled by 2^-exponent into [-1, 1], directions each by a power of two
/// of its own so that the largest component lies in [1/2, 1]; either is within 2^-53 a coordinate.
class LineImages {
 public:
  using Number = double;

  explicit LineImages(long exponent = 0) : exponent_(exponent) {}

  /// |coordinates of point| <= 2^exponent; direction not zero.
  void push_back(const Vector& point, const Vector& direction);
  /// Makes this the images of the chosen lines, which are given by numbers or by ids.
  void gather(const LineImages& all, const auto& chosen) {
    exponent_ = all.exponent_;
    for (const auto coordinate : {&LineImages::px, &LineImages::py, &LineImages::pz, &LineImages::dx, &LineImages::dy, &LineImages::dz}) {
      const std::vector<double>& from = all.*coordinate;
      std::vector<double>& to = this->*coordinate;
      to.resize(chosen.size());
      for (std::size_t i = 0; i < chosen.size(); ++i) to[i] = from[static_cast<std::uint32_t>(chosen[i])];
    }
  }
  /// Turns the direction of line i round.
  void reverse(std::size_t i);

  [[nodiscard]] std::size_t size() const { return px.size(); }
  [[nodiscard]] long exponent() const { return exponent_; }
  [[nodiscard]] Vec3<double> point(std::size_t i) const { return {px[i], py[i], pz[i]}; }
  [[nodiscard]] Vec3<double> direction(std::size_t i) const { return {dx[i], dy[i], dz[i]}; }

  std::vector<double> px, py, pz, dx, dy, dz;

 private:
  long exponent_;
};

/// An upper bound of numerator/denominator * 4^-exponent, which is >= 0: less than 2^-48 of it above; but never below the least normal
/// number, and +infinity for some values from 2^1000 on.
double image_bound(const mpz_class& numerator, const mpz_class& denominator, long exponent);

/// Replaces `unsure` by the indices of the lines of `many`, ascending, whose squared distance to line `one` of `lines` is not proved
/// to exceed `bound` strictly (parallel lines among them). `bound` is a squared distance in images, >= 0, +infinity allowed. Both sets must
/// have the same exponent.
void not_farther(const LineImages& lines, std::size_t one, const LineImages& many, double bound, std::vector<std::uint32_t>& unsure);

/// Lines [first, last) of one set; not empty.
struct LineRun {
  std::size_t first, last;

  [[nodiscard]] std::size_t size() const { return last - first; }
  friend bool operator==(const LineRun&, const LineRun&) = default;
};

/// The same among the lines of a run of `many` only.
void not_farther(const LineImages& lines, std::size_t one, const LineImages& many, LineRun run, double bound,
                 std::vector<std::uint32_t>& unsure);

/// The same for one pair: true only if line i of `a` is proved to be strictly farther from line j of `b` than the bound.
bool surely_farther(const LineImages& a, std::size_t i, const LineImages& b, std::size_t j, double bound);

/// Images of arcs: the nodes at both ends, scaled like directions.
class ArcImages {
 public:
  void push_back(const Vector& from, const Vector& to);
  std::vector<double> fx, fy, fz, tx, ty, tz;
};

/// Lines with their arcs: line i's direction is the normal of arc i's great circle. A view.
struct LineSet {
  const LineImages& images;
  const ArcImages& arcs;
};

/// As not_farther, but a pair is also left out when its arcs are proved not to cross. Arcs that touch are never proved not to cross.
void crossing_and_not_farther(const LineSet& lines, std::size_t one, const LineSet& many, double bound, std::vector<std::uint32_t>& unsure);

}  // namespace fathom::kernels
