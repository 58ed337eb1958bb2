// SPDX-License-Identifier: GPL-3.0-or-later
// The differences b - a on a narrow lattice, as Differences has them on any: the same values, without allocation.
#pragma once

#include <span>

#include "kernels/filters/rounded_plane.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {

/// One body: points on a narrow lattice, or the integer points of a cloud whose exponent is at most most_narrow_bits.
class NarrowPoints {
 public:
  explicit NarrowPoints(const NarrowCloud& cloud) : images_(cloud.images()), words_(cloud.words), fixed_(cloud.points) {}
  explicit NarrowPoints(const kernels::PointCloud& cloud) : images_(cloud.images()), integers_(cloud.points()) {}

  [[nodiscard]] std::size_t size() const { return images_.size(); }
  [[nodiscard]] const kernels::Images& images() const { return images_; }
  [[nodiscard]] Vec3<NarrowInteger> operator[](std::size_t i) const {
    if (in_words()) return widened(words_[i]);
    return integers_.empty() ? widened(fixed_[i]) : widened(integers_[i]);
  }
  [[nodiscard]] bool in_words() const { return !words_.empty(); }
  [[nodiscard]] const Vec3<std::int64_t>& word(std::size_t i) const { return words_[i]; }

 private:
  template <class NT>
  static Vec3<NarrowInteger> widened(const Vec3<NT>& p) {
    return {NarrowInteger(p.x), NarrowInteger(p.y), NarrowInteger(p.z)};
  }

  kernels::Images images_;
  std::span<const Vec3<std::int64_t>> words_;
  std::span<const Vec3<NarrowCoordinate>> fixed_;
  std::span<const Vector> integers_;
};

/// The dimension of the affine span.
int affine_rank(const NarrowPoints& points);

/// Leaves in `memory.near` the indices of all points that maximise <u, p>, ascending. u is not zero. Exact.
void find_extreme_points(const NarrowPoints& body, const Vec3<NarrowInteger>& u, long exponent, kernels::ScanMemory& memory);

/// The twin of Differences. What it is made from must outlive it.
class NarrowDifferences {
 public:
  using Integer = NarrowInteger;

  NarrowDifferences(const NarrowPair& pair, kernels::ScanMemory& memory)
      : a_(pair.a), b_(pair.b), exponent_(pair.exponent), memory_(memory) {}
  NarrowDifferences(const kernels::PointCloud& a, const kernels::PointCloud& b, kernels::ScanMemory& memory)
      : a_(a), b_(b), exponent_(a.exponent()), memory_(memory) {}

  [[nodiscard]] long exponent() const { return exponent_; }
  [[nodiscard]] Vec3<NarrowInteger> operator[](Difference d) const {
    if (!a_.in_words()) return b_[d.second] - a_[d.first];
    const Vec3<std::int64_t> difference = b_.word(d.second) - a_.word(d.first);
    return {difference.x, difference.y, difference.z};
  }
  Difference extreme(const Vec3<NarrowInteger>& u);
  [[nodiscard]] Difference likely_extreme(const Vec3<double>& n) const {
    return {kernels::likely_extreme_point(a_.images(), -n), kernels::likely_extreme_point(b_.images(), n)};
  }

 private:
  NarrowPoints a_, b_;
  long exponent_;
  kernels::ScanMemory& memory_;
};

}  // namespace fathom::polytope
