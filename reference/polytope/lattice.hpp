// SPDX-License-Identifier: GPL-3.0-or-later
// The points whose hull holds a union: all of all its pieces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/point.hpp"
#include "kernels/filters/fixed_images.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/dyadic.hpp"
#include "kernels/number/fixed_integer.hpp"
#include "kernels/positions.hpp"
#include "kernels/vector.hpp"

namespace fathom::polytope {

/// Piece after piece, each in its order; none if there are no pieces. Who has pieces from outside asks for their laws first.
inline std::vector<Point> joined(const Pieces& pieces) {
  std::vector<Point> all;
  for (const std::vector<Point>& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
  return all;
}

// Both bodies as integer points in one common unit: the form in which every later stage computes.

/// A point p of either cloud stands for origin + p / denominator. Differences b - a, hence P = B (+) (-A), do not see `origin`;
/// it only keeps the integers small when the bodies lie far from O. Indices are those of the input.
struct PlacedPair {
  mpz_class denominator = 1;  ///< > 0
  Point origin;
  kernels::PointCloud a, b;  ///< with one exponent, the least

  /// Of both clouds: |c| <= 2^exponent for every coordinate c.
  [[nodiscard]] long exponent() const { return a.exponent(); }
  /// The rational position of a lattice point, or of lattice coordinates with a further divisor: origin + v / (denominator * divisor).
  /// `divisor` must not be zero.
  [[nodiscard]] Point position(const Vector& v, const mpz_class& divisor = 1) const;
};

/// Throws std::invalid_argument when a body is empty or a coordinate is not in lowest terms over a positive denominator.
void require_bodies(kernels::Positions a, kernels::Positions b);

/// On the lattice with the least denominator for which all points, taken from the first point of B, are integral; b[0] is zero. Exact.
/// The unit is never coarser than 1: a factor that all integers share stays.
/// Size: each integer has about as many bits as the common denominator of all points, times their extent.
/// Throws as require_bodies does, and InputError when place_if_slim returns nullopt and all integers together would take more than 256 MB.
PlacedPair place(kernels::Positions a, kernels::Positions b);

/// The same, if the common denominator is in proportion to the points: it has at most 4096 bits, or eight times as many as the widest
/// coordinate. Returns nullopt otherwise: the points' denominators share little, and fewer points would have a smaller lattice.
std::optional<PlacedPair> place_if_slim(kernels::Positions a, kernels::Positions b);

/// Integer points of two bodies as clouds with one exponent, the least: the denominator is 1, the origin O.
PlacedPair place_integers(std::vector<Vector> a, std::vector<Vector> b);

// Bodies on a narrow lattice: one whose coordinates have so few bits that all of an expanding polytope's integers fit a fixed size.
// Whatever programs compute with (binary32, binary64 of similar sizes) lies on one.       [proofs/expanding.md, "Fixed integers"]

/// |c| <= 2^exponent for coordinates, with at most this exponent.
inline constexpr long most_narrow_bits = 305;
/// A coordinate of a point on a narrow lattice.
using NarrowCoordinate = kernels::FixedInteger<320>;
/// Holds all that is computed from them: at most 10 * 305 + 20 bits.
using NarrowInteger = kernels::FixedInteger<3072>;

/// A coordinate fits a word if |c| < 2^most_word_bits, and then a difference does too.
inline constexpr long most_word_bits = 62;

/// One body's points on a narrow lattice, with their images.
struct NarrowCloud {
  std::vector<Vec3<std::int64_t>> words;       ///< the points, if all coordinates of both clouds fit words
  std::vector<Vec3<NarrowCoordinate>> points;  ///< else
  std::vector<double> x, y, z;

  [[nodiscard]] kernels::Images images() const { return {x, y, z}; }
};

/// A point p of either cloud stands for origin + p / 2^shift, where the origin is the first point of B: the same lattice as that of
/// `place`.
struct NarrowPair {
  unsigned shift = 0;
  long exponent = 0;  ///< the least with |c| <= 2^exponent for every coordinate c of both clouds
  NarrowCloud a, b;
  std::vector<kernels::Dyadic> numbers;  ///< the coordinates that place_narrow was given, taken apart
};

/// The exact positions. Throws std::invalid_argument if a coordinate is no finite number.
std::vector<Point> exact_points(std::span<const std::array<double, 3>> body);
Point exact_point(const std::array<double, 3>& p);

/// Places both bodies if all coordinates are dyadic and their lattice is narrow: no rationals, and no allocation if `pair` has had room for
/// as many points before. Returns false otherwise, also for what `place` throws at: empty bodies, numbers not in lowest terms.
bool place_narrow(kernels::Positions a, kernels::Positions b, NarrowPair& pair);
/// The same for coordinates in binary64. Throws std::invalid_argument if one is no finite number.
bool place_narrow(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b, NarrowPair& pair);

// The implicit vertex set of P = B (+) (-A): all differences b - a of two clouds, at the cost of linear scans.

/// The difference b - a, by the indices of a in A and of b in B.
using Difference = std::pair<std::uint32_t, std::uint32_t>;

/// The clouds must outlive it.
struct Differences {
  using Integer = mpz_class;

  const kernels::PointCloud& a;
  const kernels::PointCloud& b;
  std::size_t scans = 0;  ///< linear scans over both clouds so far

  [[nodiscard]] Vector operator[](Difference d) const { return b[d.second] - a[d.first]; }
  /// Returns a difference that maximises <u, p>; of several the one with the lowest indices.
  Difference extreme(const Vector& u);
  /// Returns a difference that is extreme in direction n by its image, without a guarantee.
  [[nodiscard]] Difference likely_extreme(const Vec3<double>& n) const {
    return {kernels::likely_extreme_point(a.images(), -n), kernels::likely_extreme_point(b.images(), n)};
  }
  /// Of both clouds, if they share one.
  [[nodiscard]] long exponent() const { return a.exponent(); }
};

/// What the points of one body weigh in a convex combination of differences: `side` is Difference::first for A.
std::vector<Weight> weights_of(std::span<const Difference> differences, std::span<const mpq_class> weights,
                               std::uint32_t Difference::*side);

// For checks of proofs, by the definitions and in exact arithmetic only.

/// h(u) = max_b <u,b> - min_a <u,a>.
mpz_class support_naive(std::span<const Vector> a, std::span<const Vector> b, const Vector& u);
/// The weighted sum; nullopt unless the weights are convex weights of the points.
std::optional<Vec3<mpq_class>> convex_combination(std::span<const Vector> points, std::span<const Weight> weights);

// The differences b - a on a narrow lattice, as Differences has them on any: the same values, without allocation.

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
