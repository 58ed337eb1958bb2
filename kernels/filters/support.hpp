// SPDX-License-Identifier: GPL-3.0-or-later
// The support function of a finite point set, by a filtered linear scan; and what a walk to an
// extreme point asks of two or three points.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernels/number/lazy_integer.hpp"
#include "kernels/vector.hpp"

namespace fathom::kernels {

/// The binary64 images of points, one array per coordinate. Each lies in [-1, 1], within 2^-52 of
/// the scaled coordinate.
struct Images {
  std::span<const double> x, y, z;
  [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// The image of a direction: components in [-1, 1], within 2^-53 of those of the exact direction
/// after scaling.
struct DirectionImage {
  double x, y, z;
  double slack;  ///< how much less than the greatest computed value that of the farthest point can be
};
/// The slack for directions of which `bits` bounds bits of a component and of a coordinate
/// together: 0 if all is exact in binary64.
[[nodiscard]] double slack_of(long bits);

/// What a scan needs to remember; reused, it allocates nothing.
struct ScanMemory {
  std::vector<double> maxima;       // of blocks of points
  std::vector<std::uint32_t> near;  // the result
};

/// Sets `memory.near` to the indices, ascending, of all points that may be extreme in direction u:
/// those within the slack of the greatest value. If the slack is 0 they are extreme. There must be
/// a point.
void near_extreme(const Images& images, const DirectionImage& u, ScanMemory& memory);

/// Returns the index of a point that is extreme in direction u by its image, without a guarantee;
/// of several the lowest. There must be a point.
std::uint32_t likely_extreme_point(const Images& images, const Vec3<double>& u);

/// Integer points and their binary64 images. Image coordinates lie in [-1, 1], each within 2^-52 of
/// coordinate * 2^-(axis exponent).
class PointCloud {
 public:
  PointCloud() = default;
  /// With one exponent for all axes, so that clouds can share it. Throws std::invalid_argument if
  /// it is less than binary_exponent(points): images must stay in [-1, 1].
  PointCloud(std::vector<Vector> points, long exponent);
  /// With the least exponent for each axis: a body stretched along the axes looks like others.
  explicit PointCloud(std::vector<Vector> points);

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] const Vector& operator[](std::size_t i) const { return points_[i]; }
  [[nodiscard]] const std::vector<Vector>& points() const { return points_; }
  [[nodiscard]] long exponent() const { return exponent_; }
  [[nodiscard]] const Vec3<long>& axis_exponents() const { return axis_exponents_; }
  [[nodiscard]] Images images() const { return {x_, y_, z_}; }
  [[nodiscard]] std::span<const double> xs() const { return x_; }
  [[nodiscard]] std::span<const double> ys() const { return y_; }
  [[nodiscard]] std::span<const double> zs() const { return z_; }

 private:
  void make_images(const Vec3<long>& axes);

  std::vector<Vector> points_;
  std::vector<double> x_, y_, z_;
  long exponent_ = 0;
  Vec3<long> axis_exponents_{0, 0, 0};
};

/// The least e >= 0 with |coordinate| <= 2^e for every coordinate of every point.
long binary_exponent(std::span<const Vector> points);
inline long binary_exponent(const Vector& v) { return binary_exponent(std::span(&v, 1)); }

/// Indices of all points that maximise <u, p>, ascending. Exact; O(n) double operations, those of
/// wide floats for what they leave open, exact ones for what these do. u may be zero (then every
/// point is extreme). An empty cloud gives an empty list.
std::vector<std::uint32_t> extreme_points(const PointCloud& cloud, const Vector& u);
/// A cloud for directions that need not be computed: its coordinates as enclosures, and images with
/// the least exponent for each axis, whatever the cloud's own are. The cloud must outlive it.
class LazyCloud {
 public:
  explicit LazyCloud(const PointCloud& cloud);

  [[nodiscard]] const PointCloud& points() const { return *cloud_; }
  [[nodiscard]] Images images() const { return {x_, y_, z_}; }
  [[nodiscard]] const Vec3<long>& axis_exponents() const { return axes_; }
  [[nodiscard]] const Vec3<WideEnclosure>& enclosure(std::size_t i) const { return enclosures_[i]; }

 private:
  const PointCloud* cloud_;
  std::vector<Vec3<WideEnclosure>> enclosures_;
  std::vector<double> x_, y_, z_;
  Vec3<long> axes_;
};

/// The same in such a direction, not zero; the cloud is not empty. Points of the indices `level`
/// are known to have one product with u.
std::vector<std::uint32_t> extreme_points(const LazyCloud& cloud, const Vec3<LazyInteger>& u,
                                          std::span<const std::uint32_t> level = {});

/// Indices of all points with <u, p> > <u, cloud[k]>, ascending. Exact, at the same cost.
std::vector<std::uint32_t> points_beyond(const PointCloud& cloud, const Vector& u, std::uint32_t k);

/// Leaves those of `listed` whose value is greatest, in their order. `set(value, i)` writes the
/// value of i, a Number.
template <class Number, class Set>
void keep_greatest(std::vector<std::uint32_t>& listed, const Set& set) {
  using std::swap;
  std::size_t kept = 0;
  Number most, value;
  for (const std::uint32_t i : listed) {
    set(value, i);
    const int order = kept == 0 ? 1 : cmp(value, most);
    if (order < 0) continue;
    if (order > 0) {
      kept = 0;
      swap(most, value);
    }
    listed[kept++] = i;
  }
  listed.resize(kept);
}

/// True only if every point is extreme, where equal points count as one: for each a direction was
/// found in which it alone is farthest. False says nothing: some point may not be extreme, or no
/// such direction was found soon. About n log n double operations for points all over a round body;
/// no order of the points, no rounding mode and no flushing of small numbers makes it wrong.
bool all_seen_extreme(std::span<const Point> points);
bool all_seen_extreme(std::span<const std::array<double, 3>> points);

/// The naive twins: exact arithmetic only.
std::vector<std::uint32_t> extreme_points_naive(std::span<const Vector> points, const Vector& u);
std::vector<std::uint32_t> points_beyond_naive(std::span<const Vector> points, const Vector& u, std::uint32_t k);

// Points of one cloud as they appear with a direction u
/// pointing up: who is higher, and who lies to which side as seen from a third.
// Binary64 first, exact integers when it is unsure.

/// Projects along a generic direction to a plane in which u points up: coordinates (<t,p>, <u,p>)
/// with t = e_i + epsilon e_j, where epsilon is a positive infinitesimal and u, e_i, e_j are
/// linearly independent. So only the null vector projects to 0, and two vectors project to parallel
/// ones only if they are parallel themselves or both level.
class PlanarView {
 public:
  /// u must not be zero; the cloud must outlive the view.
  PlanarView(const PointCloud& cloud, const Vector& u);

  /// The sign of <u, q - p>: positive if q is higher.
  [[nodiscard]] Sign rise(std::uint32_t p, std::uint32_t q) const;
  /// Positive if the way from o to q appears to the left of the way from o to p; zero if they are
  /// parallel, or both level.
  [[nodiscard]] Sign turn(std::uint32_t o, std::uint32_t p, std::uint32_t q) const;

 private:
  [[nodiscard]] double height(std::uint32_t p, std::uint32_t q) const;

  const PointCloud* cloud_;
  Vector u_;
  Vec3<double> image_;  // of u
  int right_, far_;     // i and j
};

}  // namespace fathom::kernels
