// SPDX-License-Identifier: GPL-3.0-or-later
// Two bodies on one lattice: integer points in a common unit, the form in which every later stage
// computes. `PlacedPairIn<Integer>` is such a pair, whatever its integers. In those of any size it
// owns its points, and `place` makes it of all that are given. Where coordinates have few bits, as
// those that programs compute with (binary32, binary64 of similar sizes, short fractions),
// `place_narrow` puts the points into memory that is used again, and pairs in integers of fixed
// size are views of them.                          [proofs/expanding.md, "Fixed integers"]
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

#include "fathom/depth.hpp"
#include "fathom/point.hpp"
#include "kernels/context.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/messages.hpp"
#include "kernels/number/fixed_integer.hpp"
#include "kernels/number/lazy_integer.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/number/word_integer.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/points.hpp"

namespace fathom::polytope {

// The integers.

/// A lattice is narrow if |c| <= 2^exponent for all coordinates, with at most this exponent.
inline constexpr long most_narrow_bits = 305;
/// A coordinate of a point on a narrow lattice.
using NarrowCoordinate = kernels::FixedInteger<320>;
/// Holds all that an expanding polytope computes from them: at most 10 * 305 + 20 bits.
using NarrowInteger = kernels::FixedInteger<3072>;

/// Word integers hold all that is computed from coordinates of at most so many bits, but for
/// squared distances: <N,N> for the normal N of a triangle of differences, at most 4w + 10 bits.
template <kernels::WordInteger Integer>
inline constexpr long most_bits_for = (Integer::most_bits - 10) / 4;
static_assert(most_bits_for<kernels::Integer127> == 29 && most_bits_for<kernels::Integer255> == 61);
static_assert(most_bits_for<kernels::Integer255> < most_word_bits);

/// Calls f with a number of the shortest integers that hold everything on a narrow lattice.
template <class F>
auto with_integers_for(long exponent, F f) {
  if (exponent <= most_bits_for<kernels::Integer127>) return f(kernels::Integer127(0));
  if (exponent <= most_bits_for<kernels::Integer255>) return f(kernels::Integer255(0));
  return f(NarrowInteger(0));
}

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

// One body.

/// The difference b - a, by the indices of a in A and of b in B.
using Difference = std::pair<std::uint32_t, std::uint32_t>;

inline Vector difference(const kernels::PointCloud& a, const kernels::PointCloud& b, Difference d) {
  return b[d.second] - a[d.first];
}

/// The points of one body on a narrow lattice, as they are stored.
struct NarrowCloud {
  std::vector<Vec3<std::int64_t>> words;       ///< the points, if both bodies' coordinates fit
  std::vector<Vec3<NarrowCoordinate>> points;  ///< else
  std::vector<double> x, y, z;                 ///< their images

  [[nodiscard]] kernels::Images images() const { return {x, y, z}; }
};

/// A view of one body on a narrow lattice, in integers of fixed size. Scans are made in `memory`.
template <class Integer>
class PointsIn {
 public:
  /// `given` are the points as they were given. All must outlive it.
  PointsIn(const NarrowCloud& cloud, long exponent, const Points& given, kernels::ScanMemory& memory)
      : images_(cloud.images()),
        words_(cloud.words),
        fixed_(cloud.points),
        exponent_(exponent),
        given_(&given),
        memory_(&memory) {}
  /// Of integers of any size. It does not know how they were given.
  PointsIn(const kernels::PointCloud& cloud, kernels::ScanMemory& memory)
      : images_(cloud.images()), integers_(cloud.points()), exponent_(cloud.exponent()), memory_(&memory) {}

  [[nodiscard]] std::size_t size() const { return images_.size(); }
  [[nodiscard]] const kernels::Images& images() const { return images_; }
  [[nodiscard]] long exponent() const { return exponent_; }
  [[nodiscard]] GivenPoint given(std::size_t i) const { return (*given_)[i]; }
  [[nodiscard]] Vec3<Integer> operator[](std::size_t i) const {
    if (in_words()) return converted(words_[i]);
    if constexpr (!kernels::WordInteger<Integer>)
      if (integers_.empty()) return converted(fixed_[i]);
    return converted(integers_[i]);
  }

  friend Vec3<Integer> difference(const PointsIn& a, const PointsIn& b, Difference d) {
    if (!a.in_words()) return b[d.second] - a[d.first];
    return converted(b.words_[d.second] - a.words_[d.first]);
  }
  /// The indices of all points that maximise <u, p>, ascending, until the next call. u is not zero.
  /// Exact.
  friend const std::vector<std::uint32_t>& extreme_points(const PointsIn& body, const Vec3<Integer>& u) {
    return body.extreme(u);
  }

 private:
  [[nodiscard]] bool in_words() const { return !words_.empty(); }
  template <class NT>
  static Vec3<Integer> converted(const Vec3<NT>& p) {
    return {Integer(p.x), Integer(p.y), Integer(p.z)};
  }
  const std::vector<std::uint32_t>& extreme(const Vec3<Integer>& u) const;

  kernels::Images images_;
  std::span<const Vec3<std::int64_t>> words_;
  std::span<const Vec3<NarrowCoordinate>> fixed_;
  std::span<const Vector> integers_;
  long exponent_;
  const Points* given_ = nullptr;
  kernels::ScanMemory* memory_;
};

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
/// The form of one body in these integers.
template <class Integer>
struct BodyIn {
  using type = PointsIn<Integer>;
};
template <>
struct BodyIn<kernels::LazyInteger> {
  using type = LazyPoints;
};
template <>
struct BodyIn<mpz_class> {
  using type = kernels::PointCloud;
};
/// The integers of a body's points.
template <class Body>
using IntegerOf = std::remove_cvref_t<decltype(std::declval<const Body&>()[0].x)>;

// Their differences.

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
/// In these integers: the same values, at other costs.
template <class Integer>
using DifferencesIn = DifferencesOf<
    std::conditional_t<std::same_as<Integer, mpz_class>, const kernels::PointCloud&, typename BodyIn<Integer>::type>>;
using Differences = DifferencesIn<mpz_class>;

/// Of two clouds, which must outlive them. Their exponent must be one for which these integers are.
template <class Integer>
DifferencesIn<Integer> differences_in(const kernels::PointCloud& a, const kernels::PointCloud& b,
                                      kernels::ScanMemory& memory) {
  if constexpr (std::same_as<Integer, mpz_class>) return {a, b};
  else if constexpr (std::same_as<Integer, kernels::LazyInteger>) return {LazyPoints(a), LazyPoints(b)};
  else return {{a, memory}, {b, memory}};
}

/// Throws std::invalid_argument, with the name of the function that asks, if a body is empty or the
/// bodies differ in their exponents.
template <class Body>
void require_bodies(const DifferencesOf<Body>& differences, const char* who) {
  const auto& [a, b, scans] = differences;
  if (a.size() == 0 || b.size() == 0) throw std::invalid_argument(std::string(who) + ": an empty body");
  if (a.exponent() != b.exponent())
    throw std::invalid_argument(std::string(who) + ": the clouds differ in their exponents");
}

// Both bodies.

/// The denominator of a lattice with the unit 1.
inline const mpz_class& unit_denominator() {
  static const mpz_class one = 1;  // no memory is asked for before main()
  return one;
}

/// Two bodies on one lattice. A point p of either stands for origin + p * 2^power / denominator.
/// Differences b - a, hence P = B (+) (-A), do not see the origin, a point of B that only keeps
/// the integers small when the bodies lie far from O. Indices are those of the input.
///
/// `Integer` holds all that is computed. In mpz_class a pair owns what it is made of; in integers
/// of fixed size it is a view, which names points as they were given: only those that an answer
/// names become rationals.
template <class Integer>
struct PlacedPairIn {
  static constexpr bool owns = std::same_as<Integer, mpz_class>;

  std::conditional_t<owns, mpz_class, const mpz_class&> denominator = unit_denominator();  ///< > 0
  std::conditional_t<owns, Point, std::monostate> origin;
  typename BodyIn<Integer>::type a, b;  ///< with one exponent, the least
  long power = 0;                       ///< 0 if it owns them

  /// Of both bodies: |c| <= 2^exponent for every coordinate c.
  [[nodiscard]] long exponent() const { return a.exponent(); }
  [[nodiscard]] DifferencesIn<Integer> differences() const { return {a, b}; }
  /// The points themselves.
  [[nodiscard]] GivenPoint point_of_a(std::size_t i) const { return point(a, i); }
  [[nodiscard]] GivenPoint point_of_b(std::size_t i) const { return point(b, i); }

  /// The unit of the lattice, in that of the input; and n of them.
  [[nodiscard]] mpq_class unit() const { return {mpz_class(1) << std::max(power, 0L), units()}; }
  [[nodiscard]] mpq_class in_units(const Integer& n) const;
  /// The denominator that `place` gives to the lattice.
  [[nodiscard]] mpz_class units() const { return denominator << std::max(-power, 0L); }

  /// The rational position of a lattice point, or of lattice coordinates with a further divisor:
  /// origin + v / (denominator * divisor). `divisor` must not be zero.
  [[nodiscard]] Point position(const Vector& v,
                               const mpz_class& divisor = 1) const requires std::same_as<Integer, mpz_class>;
  /// The lattice point in that position.
  [[nodiscard]] Vector vector(const Point& position) const requires std::same_as<Integer, mpz_class>;

 private:
  template <class Body>
  GivenPoint point(const Body& body, std::size_t i) const {
    if constexpr (owns) return {position(body[i])};
    else return body.given(i);
  }
};
using PlacedPair = PlacedPairIn<mpz_class>;

/// Throws std::invalid_argument when a body is empty or a coordinate is not in lowest terms over a
/// positive denominator.
void require_bodies(polytope::Positions a, polytope::Positions b);

/// On the lattice with the least denominator for which all points, taken from the first point of B,
/// are integral; b[0] is zero. Exact. The unit is never coarser than 1: a factor that all integers
/// share stays. Size: each integer has about as many bits as the common denominator of all points,
/// times their extent. Throws as require_bodies does, and InputError when place_if_slim returns
/// nullopt and all integers together would take more than 256 MB. The context, if there is one, is
/// asked once in a megabit of coordinates whether to go on.
PlacedPair place(polytope::Positions a, polytope::Positions b, kernels::Context* context = nullptr);

/// The same, if the common denominator is in proportion to the points: it has at most 4096 bits, or
/// eight times as many as the widest coordinate. Returns nullopt otherwise: the points'
/// denominators share little, and fewer points would have a smaller lattice.
std::optional<PlacedPair> place_if_slim(polytope::Positions a, polytope::Positions b,
                                        kernels::Context* context = nullptr);

/// Integer points of two bodies on their lattice.
PlacedPair place_integers(std::vector<Vector> a, std::vector<Vector> b, mpz_class denominator = 1, Point origin = {});

// Where coordinates have few bits.

/// What place_narrow makes of two bodies; reused, it allocates nothing. The lattice is that of
/// `place`, but that a power of two that all coordinates share may have gone into the unit.
struct NarrowMemory {
  mpz_class denominator = 1;
  long power = 0;
  long exponent = 0;  ///< the least with |c| <= 2^exponent for every coordinate c of both bodies
  NarrowCloud a, b;
  std::vector<kernels::ShortRational> numbers;  ///< the coordinates, and their divisors
  kernels::Divisors divisors;

  /// The pair in integers that hold everything, of the bodies as they were given. All must outlive
  /// it.
  template <class Integer>
  [[nodiscard]] PlacedPairIn<Integer> pair(const Points& given_a, const Points& given_b,
                                           kernels::ScanMemory& memory) const {
    return {denominator, {}, {a, exponent, given_a, memory}, {b, exponent, given_b, memory}, power};
  }
};

/// Calls f with the pair in the shortest integers that hold everything.
template <class F>
auto with_pair(const NarrowMemory& placed, const Points& a, const Points& b, kernels::ScanMemory& memory, F f) {
  return with_integers_for(placed.exponent,
                           [&]<class Integer>(Integer) { return f(placed.pair<Integer>(a, b, memory)); });
}

/// Places both bodies if numerators, denominators and their least common multiple are short but for
/// powers of two, and the lattice is narrow: nothing but words and shifts, and no allocation if
/// `placed` has had room for as many points before. Returns false otherwise, also for what `place`
/// throws at: empty bodies, numbers not in lowest terms. Throws std::invalid_argument if a
/// coordinate in binary64 is no finite number.
bool place_narrow(const Points& a, const Points& b, NarrowMemory& placed);

/// The same for points in binary64 that any poses move, over the common denominator of both
/// matrices: the lattice may be finer than that of `place`, and answers that are not unique others.
/// Returns false if it is not narrow.
bool place_over_common_denominator(const PosedPoints& a, const PosedPoints& b, NarrowMemory& placed);

/// The same points on the lattice of `place`, as integers of any size. `origin` is the first point
/// of B.
PlacedPair widened(const NarrowMemory& placed, Point origin);

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
/// The same of points of the input; what is wrong with the weights goes to the report.
Point convex_combination(kernels::Report& report, const std::vector<Point>& points, const std::vector<Weight>& weights);

}  // namespace fathom::polytope
