// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies on a narrow lattice: one whose coordinates have so few bits that all of an expanding
// polytope's integers fit a fixed size. Whatever programs compute with (binary32, binary64 of
// similar sizes, short fractions) lies on one.             [proofs/expanding.md, "Fixed integers"]
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/point.hpp"
#include "kernels/filters/plane.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/fixed_integer.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/word_integer.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {

/// |c| <= 2^exponent for coordinates, with at most this exponent.
inline constexpr long most_narrow_bits = 305;
/// A coordinate of a point on a narrow lattice.
using NarrowCoordinate = kernels::FixedInteger<320>;
/// Holds all that is computed from them: at most 10 * 305 + 20 bits.
using NarrowInteger = kernels::FixedInteger<3072>;

/// A coordinate fits a word if |c| < 2^most_word_bits, and then a difference does too.
inline constexpr long most_word_bits = 62;
/// Word integers hold all that is computed from coordinates of at most so many bits, but for
/// squared distances: <N,N> for the normal N of a triangle of differences, at most 4w + 10 bits.
template <kernels::WordInteger Integer>
inline constexpr long most_bits_for = (Integer::most_bits - 10) / 4;
static_assert(most_bits_for<kernels::Integer127> == 29 && most_bits_for<kernels::Integer255> == 61);
static_assert(most_bits_for<kernels::Integer255> < most_word_bits);

/// One body's points on a narrow lattice, with their images.
struct NarrowCloud {
  std::vector<Vec3<std::int64_t>> words;       ///< the points, if all coordinates of both clouds fit words
  std::vector<Vec3<NarrowCoordinate>> points;  ///< else
  std::vector<double> x, y, z;

  [[nodiscard]] kernels::Images images() const { return {x, y, z}; }
};

/// A point p of either cloud stands for origin + p * 2^power / divisor, where the origin is the
/// first point of B. The lattice is that of `place`, but that a power of two that all coordinates
/// share may have gone into the unit.
struct NarrowPair {
  mpz_class divisor = 1;  ///< odd, > 0
  long power = 0;
  long exponent = 0;  ///< the least with |c| <= 2^exponent for every coordinate c of both clouds
  NarrowCloud a, b;

  /// Of place_narrow: the coordinates, and their divisors.
  std::vector<kernels::ShortRational> numbers;
  kernels::Divisors divisors;
};

/// Places both bodies if numerators, denominators and their least common multiple are short but for
/// powers of two, and the lattice is narrow: nothing but words and shifts, and no allocation if
/// `pair` has had room for as many points before. Returns false otherwise, also for what `place`
/// throws at: empty bodies, numbers not in lowest terms. Throws std::invalid_argument if a
/// coordinate in binary64 is no finite number.
bool place_narrow(const Points& a, const Points& b, NarrowPair& pair);

/// The same for points that poses move, both in numerators. Returns false if these have too many
/// bits over one power of two.
bool place_numerators(const PosedPoints& a, const PosedPoints& b, NarrowPair& pair);
/// The same for points in binary64 that any poses move, over the common denominator of both
/// matrices: the lattice may be finer than that of `place`, and answers that are not unique others.
/// Returns false if it is not narrow.
bool place_over_common_denominator(const PosedPoints& a, const PosedPoints& b, NarrowPair& pair);
/// Sets what follows from the points, which are in one form in both clouds: the exponent, words if
/// all coordinates fit them (of differences they may where those of points do not), the images.
void set_images(NarrowPair& pair);

/// The same for what `place` has placed. Returns false if that lattice is not narrow.
bool narrow(const PlacedPair& placed, NarrowPair& pair);
/// The same for the points alone: the unit is 1. The clouds have one exponent.
bool narrow(const kernels::PointCloud& a, const kernels::PointCloud& b, NarrowPair& pair);

/// The same points on the lattice of `place`, as integers of any size. `origin` is the first point
/// of B.
PlacedPair widened(const NarrowPair& pair, Point origin);

/// A view of one body: points on a narrow lattice, in words if the integers are, or the integer
/// points of a cloud whose exponent is at most most_narrow_bits. Scans are made in `memory`.
template <class Integer>
class NarrowPoints {
 public:
  NarrowPoints(const NarrowCloud& cloud, long exponent, kernels::ScanMemory& memory)
      : images_(cloud.images()), words_(cloud.words), fixed_(cloud.points), exponent_(exponent), memory_(&memory) {}
  NarrowPoints(const kernels::PointCloud& cloud,
               kernels::ScanMemory& memory) requires std::same_as<Integer, NarrowInteger>
      : images_(cloud.images()), integers_(cloud.points()), exponent_(cloud.exponent()), memory_(&memory) {}

  [[nodiscard]] std::size_t size() const { return images_.size(); }
  [[nodiscard]] const kernels::Images& images() const { return images_; }
  [[nodiscard]] long exponent() const { return exponent_; }
  [[nodiscard]] Vec3<Integer> operator[](std::size_t i) const {
    if constexpr (!kernels::WordInteger<Integer>)
      if (!in_words()) return integers_.empty() ? widened(fixed_[i]) : widened(integers_[i]);
    return widened(words_[i]);
  }

  friend Vec3<Integer> difference(const NarrowPoints& a, const NarrowPoints& b, Difference d) {
    if (!a.in_words()) return b[d.second] - a[d.first];
    return widened(b.words_[d.second] - a.words_[d.first]);
  }
  /// The indices of all points that maximise <u, p>, ascending, until the next call. u is not zero.
  /// Exact.
  friend const std::vector<std::uint32_t>& extreme_points(const NarrowPoints& body, const Vec3<Integer>& u) {
    return body.extreme(u);
  }

 private:
  [[nodiscard]] bool in_words() const { return !words_.empty(); }
  template <class NT>
  static Vec3<Integer> widened(const Vec3<NT>& p) {
    return {Integer(p.x), Integer(p.y), Integer(p.z)};
  }
  const std::vector<std::uint32_t>& extreme(const Vec3<Integer>& u) const;

  kernels::Images images_;
  std::span<const Vec3<std::int64_t>> words_;
  std::span<const Vec3<NarrowCoordinate>> fixed_;
  std::span<const Vector> integers_;
  long exponent_;
  kernels::ScanMemory* memory_;
};
/// The same values as those of Differences, without allocation.
template <class Integer>
using NarrowDifferences = DifferencesOf<NarrowPoints<Integer>>;

/// Bodies on a narrow lattice, with their points as they were given: only those that an answer
/// names become rationals.
template <class Integer>
class NarrowBodies {
 public:
  /// All must outlive it. `pair` is what place_narrow made of the points.
  NarrowBodies(const NarrowPair& pair, const Points& given_a, const Points& given_b, kernels::ScanMemory& memory)
      : a(pair.a, pair.exponent, memory),
        b(pair.b, pair.exponent, memory),
        pair_(pair),
        given_a_(given_a),
        given_b_(given_b) {}

  NarrowPoints<Integer> a, b;

  [[nodiscard]] long exponent() const { return pair_.exponent; }
  [[nodiscard]] NarrowDifferences<Integer> differences() const { return {a, b}; }
  [[nodiscard]] mpq_class unit() const;
  [[nodiscard]] mpq_class in_units(const Integer& n) const;
  [[nodiscard]] GivenPoint point_of_a(std::size_t i) const { return given_a_[i]; }
  [[nodiscard]] GivenPoint point_of_b(std::size_t i) const { return given_b_[i]; }
  [[nodiscard]] mpz_class units() const;

 private:
  const NarrowPair& pair_;
  Points given_a_, given_b_;
};

/// Calls f with a number of the shortest integers that hold everything.
template <class F>
auto with_integers_for(const NarrowPair& pair, F f) {
  const bool words = !pair.a.words.empty();
  if (words && pair.exponent <= most_bits_for<kernels::Integer127>) return f(kernels::Integer127(0));
  if (words && pair.exponent <= most_bits_for<kernels::Integer255>) return f(kernels::Integer255(0));
  return f(NarrowInteger(0));
}

/// Calls f with the bodies in these integers.
template <class F>
auto with_narrow_bodies(const NarrowPair& pair, const Points& a, const Points& b, kernels::ScanMemory& memory, F f) {
  return with_integers_for(pair, [&]<class Integer>(Integer) { return f(NarrowBodies<Integer>(pair, a, b, memory)); });
}

}  // namespace fathom::polytope
