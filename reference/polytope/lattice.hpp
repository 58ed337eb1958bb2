// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies on one lattice: from points in any form to integer points in a common unit, the form
// in which every later stage computes. Here the integers are mpz_class; where few bits do, see
// narrow_lattice.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/body.hpp"
#include "fathom/depth.hpp"
#include "fathom/point.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/fixed_integer.hpp"
#include "kernels/number/lazy_integer.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/word_integer.hpp"
#include "kernels/positions.hpp"
#include "kernels/vector.hpp"

namespace fathom::polytope {

/// Returns the points of all pieces, whose hull holds the union: piece after piece, each in its
/// order. Does not check the laws of pieces.
inline std::vector<Point> joined(const Pieces& pieces) {
  std::vector<Point> all;
  for (const std::vector<Point>& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
  return all;
}

/// Numbers in binary64 as integers times one power of two.
struct AlignedNumbers {
  std::vector<std::int64_t> integers;
  long exponent = 0;
  long bits = 0;  ///< |n| < 2^bits for each integer
};

/// Returns nullopt if an integer would have more bits than a word. Throws std::invalid_argument if
/// a number is not finite.
std::optional<AlignedNumbers> aligned(std::span<const double> numbers);

/// Points of a body that a pose moves. What they are made from must outlive them.
struct PosedPoints {
  static constexpr long most_bits = 124;

  const GivenPoints* given = nullptr;        ///< all points of the body, before they are moved
  const AlignedNumbers* integers = nullptr;  ///< their coordinates, if these are in binary64 and can be aligned
  std::span<const std::uint32_t> chosen;     ///< which of them these are; empty: all
  const std::variant<PoseBinary64, Pose>* pose = nullptr;  ///< numbers finite, or in lowest terms
  /// The moved points over 2^-exponent, if all is in binary64 and each |n| < 2^most_bits; or none.
  std::vector<Vec3<kernels::Int128>> numerators;
  long exponent = 0;

  /// Makes the numerators, if 128 bits suffice, of what is set above. Throws std::invalid_argument
  /// if a number of the pose is not finite, or not in lowest terms.
  void move();

  [[nodiscard]] std::size_t size() const { return chosen.empty() ? given->size() : chosen.size(); }
  /// Which point of the body the i-th of these is.
  [[nodiscard]] std::size_t index(std::size_t i) const { return chosen.empty() ? i : chosen[i]; }
  [[nodiscard]] GivenPoint point(std::size_t i) const;
};

/// A view of the points of a body in the form in which they were given: coordinates in binary64,
/// exact points, the centers of atoms, or moved points. What it is made from must outlive it.
class Points {
 public:
  using Doubles = std::span<const std::array<double, 3>>;

  template <class Range>
  requires std::is_convertible_v<const Range&, Doubles> Points(
      const Range& points)  // NOLINT(google-explicit-constructor)
      : doubles_(points), exact_(nullptr, 0) {}
  template <class Range>
  requires std::is_convertible_v<const Range&, kernels::Positions> Points(
      const Range& points)  // NOLINT(google-explicit-constructor)
      : exact_(points) {}
  Points(const GivenPoints& points)  // NOLINT(google-explicit-constructor)
      : doubles_(points.binary64()),
        exact_(points.in_binary64() ? kernels::Positions(nullptr, 0) : kernels::Positions(points.exact())) {}
  Points(const PosedPoints& points)  // NOLINT(google-explicit-constructor)
      : exact_(nullptr, 0), posed_(&points) {}

  [[nodiscard]] std::size_t size() const {
    return posed_ != nullptr ? posed_->size() : doubles_.size() + exact_.size();
  }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] GivenPoint operator[](std::size_t i) const {
    if (posed_ != nullptr) return posed_->point(i);
    if (doubles_.empty()) return {exact_[i]};
    return {doubles_[i]};
  }
  /// The points that a pose moves, if they are the form; else null.
  [[nodiscard]] const PosedPoints* posed() const { return posed_; }
  /// The exact points, where they stand or else in `room`, which must outlive them.
  [[nodiscard]] kernels::Positions exact(std::vector<Point>& room) const;

  /// Calls f(coordinate), with numbers of binary64 or with rationals, until it returns false.
  /// Returns whether it never did.
  template <class F>
  bool all_coordinates(F f) const {
    for (const std::array<double, 3>& p : doubles_)
      if (!f(p[0]) || !f(p[1]) || !f(p[2])) return false;
    for (const Point& p : exact_)
      if (!f(p.x) || !f(p.y) || !f(p.z)) return false;
    for (std::size_t i = 0; posed_ != nullptr && i < size(); ++i)
      if (const Point p = (*this)[i].exact(); !f(p.x) || !f(p.y) || !f(p.z)) return false;
    return true;
  }

 private:
  Doubles doubles_;
  kernels::Positions exact_;  // if they are not in binary64
  const PosedPoints* posed_ = nullptr;
};

/// The exact positions. Throws std::invalid_argument if a coordinate is no finite number.
std::vector<Point> exact_points(std::span<const std::array<double, 3>> body);

/// The difference b - a, by the indices of a in A and of b in B.
using Difference = std::pair<std::uint32_t, std::uint32_t>;

/// Integers of any kind as those of any size.
inline const mpz_class& to_mpz(const mpz_class& n) { return n; }
template <unsigned Bits>
mpz_class to_mpz(const kernels::FixedInteger<Bits>& n) {
  return n.to_mpz();
}
using kernels::to_mpz;
inline const Vector& to_vector(const Vector& v) { return v; }
template <class Integer>
Vector to_vector(const Vec3<Integer>& v) {
  return {to_mpz(v.x), to_mpz(v.y), to_mpz(v.z)};
}

/// The integers of a body's points.
template <class Body>
using IntegerOf = std::remove_cvref_t<decltype(std::declval<const Body&>()[0].x)>;

inline Vector difference(const kernels::PointCloud& a, const kernels::PointCloud& b, Difference d) {
  return b[d.second] - a[d.first];
}

/// Up to three points of A, and of B, that are known to have one product with a direction.
struct LevelPoints {
  struct Ids {
    std::array<std::uint32_t, 3> ids{};
    std::size_t count = 0;
    [[nodiscard]] std::span<const std::uint32_t> all() const { return std::span(ids).first(count); }
    [[nodiscard]] bool holds(std::uint32_t i) const { return std::ranges::count(all(), i) > 0; }
  } a, b;
};

/// The implicit vertex set of P = B (+) (-A): all differences b - a of two bodies, at the cost of
/// linear scans. The bodies must outlive it.
template <class Body>
struct DifferencesOf {
  using Integer = IntegerOf<Body>;

  Body a, b;
  std::size_t scans = 0;  ///< linear scans over both bodies so far

  [[nodiscard]] Vec3<Integer> operator[](Difference d) const { return difference(a, b, d); }
  /// Returns a difference that maximises <u, p>; of several the one with the lowest indices. Exact.
  Difference extreme(const Vec3<Integer>& u) {
    ++scans;
    if (is_zero(u)) return {0, 0};
    const std::uint32_t first = extreme_points(a, -u).front();
    return {first, extreme_points(b, u).front()};
  }
  /// The same in lazy integers, not zero: points that are known to be level need not be compared.
  Difference extreme(const Vec3<Integer>& u,
                     const LevelPoints& level) requires std::same_as<Integer, kernels::LazyInteger> {
    ++scans;
    const std::uint32_t first = extreme_points(a, -u, level.a.all()).front();
    return {first, extreme_points(b, u, level.b.all()).front()};
  }
  /// Returns a difference that is extreme in direction n by its image, without a guarantee.
  [[nodiscard]] Difference likely_extreme(const Vec3<double>& n) const {
    return {kernels::likely_extreme_point(a.images(), -n), kernels::likely_extreme_point(b.images(), n)};
  }
  /// Of both bodies, if they share one.
  [[nodiscard]] long exponent() const { return a.exponent(); }
};
using Differences = DifferencesOf<const kernels::PointCloud&>;

/// A view of a cloud, in integers that are computed when they are needed.
class LazyPoints {
 public:
  /// The cloud must outlive it.
  explicit LazyPoints(const kernels::PointCloud& cloud) : cloud_(cloud) {}

  [[nodiscard]] std::size_t size() const { return cloud_.points().size(); }
  [[nodiscard]] kernels::Images images() const { return cloud_.points().images(); }
  [[nodiscard]] long exponent() const { return cloud_.points().exponent(); }
  [[nodiscard]] Vec3<kernels::LazyInteger> operator[](std::size_t i) const { return lazy(cloud_.points()[i]); }

  friend Vec3<kernels::LazyInteger> difference(const LazyPoints& a, const LazyPoints& b, Difference d) {
    return lazy(difference(a.cloud_.points(), b.cloud_.points(), d));
  }
  friend std::vector<std::uint32_t> extreme_points(const LazyPoints& body, const Vec3<kernels::LazyInteger>& u,
                                                   std::span<const std::uint32_t> level = {}) {
    return kernels::extreme_points(body.cloud_, u, level);
  }

 private:
  static Vec3<kernels::LazyInteger> lazy(const Vector& v) {
    return {kernels::LazyInteger(v.x), kernels::LazyInteger(v.y), kernels::LazyInteger(v.z)};
  }

  kernels::LazyCloud cloud_;
};
using LazyDifferences = DifferencesOf<LazyPoints>;

/// Throws std::invalid_argument, with the name of the function that asks, if a body is empty or the
/// bodies differ in their exponents.
template <class Body>
void require_bodies(const DifferencesOf<Body>& differences, const char* who) {
  const auto& [a, b, scans] = differences;
  if (a.size() == 0 || b.size() == 0) throw std::invalid_argument(std::string(who) + ": an empty body");
  if (a.exponent() != b.exponent())
    throw std::invalid_argument(std::string(who) + ": the clouds differ in their exponents");
}

/// Bodies on any lattice. A point p of either cloud stands for origin + p / denominator.
/// Differences b - a, hence P = B (+) (-A), do not see `origin`; it only keeps the integers small
/// when the bodies lie far from O. Indices are those of the input.
struct PlacedPair {
  mpz_class denominator = 1;  ///< > 0
  Point origin;
  kernels::PointCloud a, b;  ///< with one exponent, the least

  /// Of both clouds: |c| <= 2^exponent for every coordinate c.
  [[nodiscard]] long exponent() const { return a.exponent(); }
  /// The rational position of a lattice point, or of lattice coordinates with a further divisor:
  /// origin + v / (denominator * divisor). `divisor` must not be zero.
  [[nodiscard]] Point position(const Vector& v, const mpz_class& divisor = 1) const;
  /// The lattice point in that position.
  [[nodiscard]] Vector vector(const Point& position) const;

  // What NarrowBodies has too, for the steps that are templates over the integers.

  [[nodiscard]] Differences differences() const { return {a, b}; }
  /// The unit of the lattice, in that of the input; and n of them.
  [[nodiscard]] mpq_class unit() const { return {1, denominator}; }
  [[nodiscard]] mpq_class in_units(const mpz_class& n) const;
  /// The points themselves.
  [[nodiscard]] GivenPoint point_of_a(std::size_t i) const { return {position(a[i])}; }
  [[nodiscard]] GivenPoint point_of_b(std::size_t i) const { return {position(b[i])}; }
  /// The denominator of `place`.
  [[nodiscard]] const mpz_class& units() const { return denominator; }
};

/// Throws std::invalid_argument when a body is empty or a coordinate is not in lowest terms over a
/// positive denominator.
void require_bodies(kernels::Positions a, kernels::Positions b);

/// On the lattice with the least denominator for which all points, taken from the first point of B,
/// are integral; b[0] is zero. Exact. The unit is never coarser than 1: a factor that all integers
/// share stays. Size: each integer has about as many bits as the common denominator of all points,
/// times their extent. Throws as require_bodies does, and InputError when place_if_slim returns
/// nullopt and all integers together would take more than 256 MB. The context, if there is one, is
/// asked once in a megabit of coordinates whether to go on.
PlacedPair place(kernels::Positions a, kernels::Positions b, kernels::Context* context = nullptr);

/// The same, if the common denominator is in proportion to the points: it has at most 4096 bits, or
/// eight times as many as the widest coordinate. Returns nullopt otherwise: the points'
/// denominators share little, and fewer points would have a smaller lattice.
std::optional<PlacedPair> place_if_slim(kernels::Positions a, kernels::Positions b,
                                        kernels::Context* context = nullptr);

/// Integer points of two bodies as clouds with one exponent, the least: the denominator is 1, the
/// origin O.
PlacedPair place_integers(std::vector<Vector> a, std::vector<Vector> b);

/// What the points of one body weigh in a convex combination of differences: `side` is
/// Difference::first for A.
std::vector<Weight> weights_of(std::span<const Difference> differences, std::span<const mpq_class> weights,
                               std::uint32_t Difference::*side);
/// The same for integers over a denominator.
template <class Integer>
std::vector<Weight> weights_of(std::span<const Difference> differences, const std::vector<Integer>& numerators,
                               const Integer& denominator, std::uint32_t Difference::*side) {
  std::vector<mpq_class> weights;
  for (const Integer& n : numerators) weights.push_back(kernels::ratio(to_mpz(n), to_mpz(denominator)));
  return weights_of(differences, weights, side);
}

// For checks of proofs, by the definitions and in exact arithmetic only.

/// h(u) = max_b <u,b> - min_a <u,a>.
mpz_class support_naive(std::span<const Vector> a, std::span<const Vector> b, const Vector& u);
/// The weighted sum; nullopt unless the weights are convex weights of the points.
std::optional<Vec3<mpq_class>> convex_combination(std::span<const Vector> points, std::span<const Weight> weights);

}  // namespace fathom::polytope
