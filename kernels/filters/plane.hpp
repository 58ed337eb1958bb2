// SPDX-License-Identifier: GPL-3.0-or-later
// Where points lie about the plane through three of them: doubles with a bound on the error, then
// intervals, integers when the interval holds zero. For questions asked many times of one plane,
// among points of one set.                                     [proofs/kernels.md, "Plain doubles"]
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "kernels/predicates/direction.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// Integer points with enclosures in one common scale. Refers to the points, which must outlive it.
class BoxedPoints {
 public:
  explicit BoxedPoints(std::span<const Vector> exact);

  [[nodiscard]] const Vector& exact(std::uint32_t i) const { return exact_[i]; }
  [[nodiscard]] const Vec3<DoubleInterval>& box(std::uint32_t i) const { return boxes_[i]; }
  /// In [-1, 1], within 2^-53 of the exact coordinates in that scale.
  [[nodiscard]] const Vec3<double>& rounded(std::uint32_t i) const { return images_[i]; }

 private:
  std::span<const Vector> exact_;
  std::vector<Vec3<DoubleInterval>> boxes_;
  std::vector<Vec3<double>> images_;
};

/// The oriented plane through points p, q, r; n = (q - p) x (r - p) points to the side from which
/// they appear counter-clockwise. Refers to the points, which must outlive it. Not to be shared
/// between threads: answers are remembered.
class Plane {
 public:
  Plane(const BoxedPoints& points, std::uint32_t p, std::uint32_t q, std::uint32_t r);

  /// The sign of <n, s - p>.
  [[nodiscard]] Sign side(std::uint32_t s) const { return rise(p_, s); }
  /// The sign of <n, t - s>: positive if t lies higher than s.
  [[nodiscard]] Sign rise(std::uint32_t s, std::uint32_t t) const;
  /// Whether p, q, r lie on one line: n = 0.
  [[nodiscard]] bool degenerate() const;
  /// n exactly, not reduced.
  [[nodiscard]] const Vector& normal() const;

 private:
  [[nodiscard]] const Vec3<DoubleInterval>& box() const;

  const BoxedPoints* points_;
  std::uint32_t p_, q_, r_;
  Vec3<double> image_;   // of n, up to the points' scale
  double size_, error_;  // the image's largest component, and a bound on the error of each
  mutable std::optional<Vec3<DoubleInterval>>
      box_;  // of n, in the same scale. Computed when the image is unsure for the first time
  mutable std::optional<Vector> normal_;  // Computed when the box is unsure for the first time
};

/// The points as seen along coordinate `axis` (0, 1, 2 for x, y, z) from its positive end, where
/// the two coordinates that follow it cyclically point right and up: positive if p, q, r turn left,
/// zero if they lie on one line.
Sign turn(const BoxedPoints& points, int axis, std::uint32_t p, std::uint32_t q, std::uint32_t r);

}  // namespace fathom::kernels
