// SPDX-License-Identifier: GPL-3.0-or-later
// Rationals are multiplied by their common denominator, and what all integers share is divided out.
// Dyadic numbers need shifts only: the unit is the lowest bit that any coordinate has.
#include "reference/polytope/lattice.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "kernels/filters/plane.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/polytope/polytope.hpp"

namespace fathom::polytope {
namespace {

// A common denominator with at most this many bits never costs much; a longer one is compared with
// the coordinates.
constexpr std::size_t short_enough = 4096;
constexpr std::size_t times_the_widest = 8;
// Of all coordinates together, where the denominator outgrows them: 256 MB.
constexpr std::uint64_t most_bits = std::uint64_t{1} << 31;

std::size_t bits(const mpz_class& n) { return mpz_sizeinbase(n.get_mpz_t(), 2); }

/// Asks the context, if there is one, once in a megabit of numbers: what is done to a few long ones
/// takes as long as what is done to many short ones.
class Asking {
 public:
  explicit Asking(kernels::Context* context) : context_(context) {}
  void after(const mpq_class& q) { after_limbs(mpz_size(q.get_num_mpz_t()) + mpz_size(q.get_den_mpz_t())); }
  void after(const mpz_class& n) { after_limbs(mpz_size(n.get_mpz_t())); }
  void after(const Point& p) {
    for (const mpq_class* q : {&p.x, &p.y, &p.z}) after(*q);
  }

 private:
  void after_limbs(std::size_t limbs) {
    if (context_ == nullptr || (limbs_ += limbs) < (std::size_t{1} << 20) / GMP_NUMB_BITS) return;
    limbs_ = 0;
    context_->check();
  }

  kernels::Context* context_;
  std::size_t limbs_ = 0;
};

/// Until f(coordinate) is false; tells whether it never was.
template <class F>
bool all_coordinates(kernels::Positions a, kernels::Positions b, F f) {
  for (const kernels::Positions body : {a, b}) {
    for (const Point& p : body)
      if (!f(p.x) || !f(p.y) || !f(p.z)) return false;
  }
  return true;
}

/// The most bits that a common denominator in proportion to the coordinates has.
std::size_t in_proportion(kernels::Positions a, kernels::Positions b) {
  std::size_t widest = 0;
  all_coordinates(a, b, [&](const mpq_class& q) {
    widest = std::max({widest, bits(q.get_num()), bits(q.get_den())});
    return true;
  });
  return std::max(short_enough, times_the_widest * widest);
}

/// The common denominator; 0 as soon as more(its bits) is false. Denominators repeat a great deal,
/// so divisibility is asked first.
template <class More>
mpz_class common_denominator(kernels::Positions a, kernels::Positions b, Asking& asking, More more) {
  mpz_class common = 1;
  const bool all = all_coordinates(a, b, [&](const mpq_class& q) {
    asking.after(q);
    if (mpz_divisible_p(common.get_mpz_t(), q.get_den_mpz_t())) return true;
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), q.get_den_mpz_t());
    return more(bits(common));
  });
  return all ? common : mpz_class(0);
}

/// q * denominator, which the caller knows to be an integer.
mpz_class multiple(const mpq_class& q, const mpz_class& denominator) {
  mpz_class n;
  mpz_divexact(n.get_mpz_t(), denominator.get_mpz_t(), q.get_den_mpz_t());
  n *= q.get_num();
  return n;
}

Vector multiple(const Point& p, const mpz_class& denominator) {
  return {multiple(p.x, denominator), multiple(p.y, denominator), multiple(p.z, denominator)};
}

/// The points of both bodies while they are made.
struct Lattice {
  mpz_class denominator = 1;
  Point origin;
  std::vector<Vector> a, b;
};

PlacedPair with_clouds(Lattice lattice) {
  PlacedPair pair = place_integers(std::move(lattice.a), std::move(lattice.b));
  pair.denominator = std::move(lattice.denominator);
  pair.origin = std::move(lattice.origin);
  return pair;
}

std::vector<Vector> shifted_multiples(kernels::Positions body, const mpz_class& denominator, const Vector& origin,
                                      Asking& asking) {
  std::vector<Vector> result;
  result.reserve(body.size());
  for (const Point& p : body) {
    asking.after(p);
    Vector v = multiple(p, denominator);
    v.x -= origin.x;
    v.y -= origin.y;
    v.z -= origin.z;
    result.push_back(std::move(v));
  }
  return result;
}

template <class F>
void for_each_coordinate(Lattice& lattice, F f) {
  for (std::vector<Vector>* body : {&lattice.a, &lattice.b}) {
    for (Vector& v : *body) {
      f(v.x);
      f(v.y);
      f(v.z);
    }
  }
}

/// Points such as 1/3, 4/3, 7/3 need a denominator, their differences do not: divides out what all
/// coordinates and it share.
void coarsen(Lattice& lattice, Asking& asking) {
  mpz_class shared = lattice.denominator;
  for_each_coordinate(lattice, [&](const mpz_class& c) {
    asking.after(c);
    if (shared != 1) mpz_gcd(shared.get_mpz_t(), shared.get_mpz_t(), c.get_mpz_t());
  });
  if (shared == 1) return;
  mpz_divexact(lattice.denominator.get_mpz_t(), lattice.denominator.get_mpz_t(), shared.get_mpz_t());
  for_each_coordinate(lattice, [&](mpz_class& c) {
    asking.after(c);
    mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), shared.get_mpz_t());
  });
}

std::vector<Point> offsets(kernels::Positions body, const Point& origin, Asking& asking) {
  std::vector<Point> result;
  result.reserve(body.size());
  for (const Point& p : body) {
    result.push_back(p - origin);
    asking.after(result.back());
  }
  return result;
}

void require_bodies(kernels::Positions a, kernels::Positions b, Asking& asking) {
  if (a.empty() || b.empty()) throw std::invalid_argument("a body needs at least one point");
  all_coordinates(a, b, [&](const mpq_class& q) {
    kernels::require_lowest_terms(q);
    asking.after(q);
    return true;
  });
}

/// For points whose common denominator is much longer than they are: what differences do not need
/// is left out first, and there are limits.
PlacedPair place_wide(kernels::Positions a, kernels::Positions b, Asking& asking) {
  Lattice lattice;
  lattice.origin = b.front();
  const std::vector<Point> from_a = offsets(a, lattice.origin, asking), from_b = offsets(b, lattice.origin, asking);
  const std::uint64_t coordinates = 3 * (a.size() + b.size());
  lattice.denominator =
      common_denominator(from_a, from_b, asking, [&](std::size_t size) { return size * coordinates <= most_bits; });
  if (lattice.denominator == 0) {
    throw InputError("input", 0,
                     "the denominators of the " + std::to_string(a.size() + b.size()) +
                         " points share too little: " + "over a common one all coordinates together would pass " +
                         std::to_string(most_bits >> 23) + " MB");
  }
  const Vector no_shift{0, 0, 0};
  lattice.a = shifted_multiples(from_a, lattice.denominator, no_shift, asking);
  lattice.b = shifted_multiples(from_b, lattice.denominator, no_shift, asking);
  return with_clouds(std::move(lattice));
}

// The bits that coordinates have: none below 2^low, none from 2^high on.
struct Range {
  long low = 0, high = std::numeric_limits<long>::min();

  // Adds the numbers to the list. False if some number is not dyadic.
  bool cover(const Points& body, std::vector<kernels::Dyadic>& numbers) {
    return body.all_coordinates([&](const auto& c) {
      const std::optional<kernels::Dyadic> value = kernels::dyadic(c);
      if (!value) return false;
      numbers.push_back(*value);
      if (value->mantissa == 0) return true;
      low = std::min(low, value->exponent);
      const auto magnitude = static_cast<std::uint64_t>(value->mantissa < 0 ? -value->mantissa : value->mantissa);
      high = std::max(high, value->exponent + static_cast<long>(std::bit_width(magnitude)));
      return true;
    });
  }
};

// The point of these three coordinates in units of 2^low.
void put(const kernels::Dyadic* p, long low, Vec3<std::int64_t>& q) {
  const auto at = [&](const kernels::Dyadic& c) { return c.mantissa == 0 ? 0 : c.mantissa << (c.exponent - low); };
  q = {at(p[0]), at(p[1]), at(p[2])};
}
void put(const kernels::Dyadic* p, long low, Vec3<NarrowCoordinate>& q) {
  const auto at = [&](const kernels::Dyadic& c) {
    return NarrowCoordinate::shifted(c.mantissa, c.mantissa == 0 ? 0 : static_cast<unsigned>(c.exponent - low));
  };
  q = {at(p[0]), at(p[1]), at(p[2])};
}

// Of coordinates: the least number of trailing zeros, and the least e >= 0 with |c| <= 2^e.
template <class Row>
class Extent;

template <>
class Extent<Vec3<std::int64_t>> {
 public:
  void cover(std::int64_t c) {
    all_ |= static_cast<std::uint64_t>(c);
    largest_ = std::max(largest_, c < 0 ? -static_cast<std::uint64_t>(c) : static_cast<std::uint64_t>(c));
  }
  [[nodiscard]] unsigned trailing_zeros() const {
    return all_ == 0 ? std::numeric_limits<unsigned>::max() : static_cast<unsigned>(std::countr_zero(all_));
  }
  [[nodiscard]] long exponent() const { return largest_ == 0 ? 0 : std::bit_width(largest_ - 1); }

 private:
  std::uint64_t all_ = 0, largest_ = 0;
};

template <>
class Extent<Vec3<NarrowCoordinate>> {
 public:
  void cover(const NarrowCoordinate& c) {
    if (sgn(c) == 0) return;
    zeros_ = std::min(zeros_, c.trailing_zeros());
    if (c.bit_length() > exponent_) exponent_ = std::max(exponent_, kernels::binary_exponent(c));
  }
  [[nodiscard]] unsigned trailing_zeros() const { return zeros_; }
  [[nodiscard]] long exponent() const { return exponent_; }

 private:
  unsigned zeros_ = std::numeric_limits<unsigned>::max();
  long exponent_ = 0;
};

// Only 0 has as many trailing zeros as a word has bits, or more.
void divide_by_power(std::int64_t& c, unsigned shift) { c = shift < 64 ? c >> shift : 0; }
void divide_by_power(NarrowCoordinate& c, unsigned shift) { c.divide_by_power(shift); }

template <class Row>
void make_images(const std::vector<Row>& points, long exponent, NarrowCloud& cloud) {
  for (std::vector<double>* images : {&cloud.x, &cloud.y, &cloud.z}) images->resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.x[i] = kernels::image(points[i].x, exponent);
    cloud.y[i] = kernels::image(points[i].y, exponent);
    cloud.z[i] = kernels::image(points[i].z, exponent);
  }
}

// From `pair.numbers`, in words or in wider integers: `list` is one of a cloud's two lists.
template <class Row>
void fill(std::size_t size_a, long low, NarrowPair& pair, std::vector<Row> NarrowCloud::*list) {
  Row origin;
  put(&pair.numbers[3 * size_a], low, origin);
  Extent<Row> extent;
  const kernels::Dyadic* p = pair.numbers.data();
  for (const auto& [size, points] :
       {std::pair(size_a, &(pair.a.*list)), std::pair(pair.numbers.size() / 3 - size_a, &(pair.b.*list))}) {
    points->resize(size);
    for (Row& q : *points) {
      put(p, low, q);
      p += 3;
      q = q - origin;
      extent.cover(q.x);
      extent.cover(q.y);
      extent.cover(q.z);
    }
  }
  // The powers of two that all coordinates and the denominator share, which `place` divides out
  // too. All coordinates may be 0.
  const unsigned shared = std::min(static_cast<unsigned>(-low), extent.trailing_zeros());
  pair.shift = static_cast<unsigned>(-low) - shared;
  pair.exponent = std::max(extent.exponent() - static_cast<long>(shared), 0L);
  for (NarrowCloud* cloud : {&pair.a, &pair.b}) {
    std::vector<Row>& points = cloud->*list;
    for (Row& p : points) {
      if (shared == 0) break;
      divide_by_power(p.x, shared);
      divide_by_power(p.y, shared);
      divide_by_power(p.z, shared);
    }
    make_images(points, pair.exponent, *cloud);
  }
}

}  // namespace

void require_bodies(kernels::Positions a, kernels::Positions b) {
  Asking nobody(nullptr);
  require_bodies(a, b, nobody);
}

std::optional<PlacedPair> place_if_slim(kernels::Positions a, kernels::Positions b, kernels::Context* context) {
  Asking asking(context);
  require_bodies(a, b, asking);
  std::size_t limit = short_enough;
  Lattice lattice;
  lattice.denominator = common_denominator(a, b, asking, [&](std::size_t size) {
    if (size > limit && limit == short_enough) limit = in_proportion(a, b);
    return size <= limit;
  });
  if (lattice.denominator == 0) return std::nullopt;
  lattice.origin = b.front();
  const Vector origin = multiple(b.front(), lattice.denominator);
  lattice.a = shifted_multiples(a, lattice.denominator, origin, asking);
  lattice.b = shifted_multiples(b, lattice.denominator, origin, asking);
  coarsen(lattice, asking);
  return with_clouds(std::move(lattice));
}

PlacedPair place(kernels::Positions a, kernels::Positions b, kernels::Context* context) {
  if (std::optional<PlacedPair> slim = place_if_slim(a, b, context)) return std::move(*slim);
  Asking asking(context);
  return place_wide(a, b, asking);
}

PlacedPair place_integers(std::vector<Vector> a, std::vector<Vector> b) {
  const long exponent = std::max(kernels::binary_exponent(a), kernels::binary_exponent(b));
  PlacedPair pair;
  pair.a = kernels::PointCloud(std::move(a), exponent);
  pair.b = kernels::PointCloud(std::move(b), exponent);
  return pair;
}

mpq_class PlacedPair::over_unit(const mpz_class& n) const { return kernels::ratio(n, denominator); }

Point PlacedPair::position(const Vector& v, const mpz_class& divisor) const {
  const mpz_class unit = denominator * divisor;
  return {origin.x + kernels::ratio(v.x, unit), origin.y + kernels::ratio(v.y, unit),
          origin.z + kernels::ratio(v.z, unit)};
}

kernels::Positions Points::exact(std::vector<Point>& room) const {
  if (doubles_.empty()) return exact_;
  room = exact_points(doubles_);
  return room;
}

std::vector<Point> exact_points(std::span<const std::array<double, 3>> body) {
  std::vector<Point> points;
  points.reserve(body.size());
  for (const std::array<double, 3>& p : body)
    points.push_back({exact_value(p[0]), exact_value(p[1]), exact_value(p[2])});
  return points;
}

bool place_narrow(const Points& a, const Points& b, NarrowPair& pair) {
  Range range;
  pair.numbers.clear();
  if (a.empty() || b.empty() || !range.cover(a, pair.numbers) || !range.cover(b, pair.numbers)) return false;
  const long bits = std::max(range.high, range.low) - range.low + 1;  // of the differences from the origin
  if (bits > most_narrow_bits) return false;
  for (NarrowCloud* cloud : {&pair.a, &pair.b}) {
    cloud->words.clear();
    cloud->points.clear();
  }
  if (bits <= most_word_bits) fill(a.size(), range.low, pair, &NarrowCloud::words);
  else fill(a.size(), range.low, pair, &NarrowCloud::points);
  return true;
}

PlacedPair widened(const NarrowPair& pair, Point origin) {
  const auto cloud = [&](const NarrowCloud& narrow) {
    std::vector<Vector> points;
    points.reserve(narrow.x.size());
    for (const Vec3<std::int64_t>& p : narrow.words) points.push_back({p.x, p.y, p.z});
    for (const Vec3<NarrowCoordinate>& p : narrow.points) points.push_back(to_vector(p));
    return kernels::PointCloud(std::move(points), pair.exponent);
  };
  return {mpz_class(1) << pair.shift, std::move(origin), cloud(pair.a), cloud(pair.b)};
}

template <class Integer>
const std::vector<std::uint32_t>& NarrowPoints<Integer>::extreme(const Vec3<Integer>& u) const {
  const kernels::DirectionImage v = kernels::direction_image_for(u, exponent_);
  kernels::near_extreme(images_, v, *memory_);
  std::vector<std::uint32_t>& near = memory_->near;
  if (near.size() == 1 || v.slack == 0) return near;
  std::size_t kept = 0;
  Integer most;
  for (const std::uint32_t i : near) {
    const Integer value = dot(u, (*this)[i]);
    const int order = kept == 0 ? 1 : cmp(value, most);
    if (order < 0) continue;
    if (order > 0) {
      kept = 0;
      most = value;
    }
    near[kept++] = i;
  }
  near.resize(kept);
  return near;
}

template <class Integer>
mpq_class NarrowBodies<Integer>::over_unit(const Integer& n) const {
  mpq_class q;
  if (sgn(n) == 0) return q;
  q.get_num() = to_mpz(n);
  const auto shared = static_cast<unsigned>(std::min<mp_bitcnt_t>(pair_.shift, mpz_scan1(q.get_num_mpz_t(), 0)));
  mpz_tdiv_q_2exp(q.get_num_mpz_t(), q.get_num_mpz_t(), shared);
  q.get_den() <<= pair_.shift - shared;
  return q;
}

template <class Integer>
PlacedPair NarrowBodies<Integer>::frame() const {
  PlacedPair pair;
  pair.denominator = units();
  pair.origin = given_b_[0].exact();
  return pair;
}

template class NarrowPoints<kernels::Integer127>;
template class NarrowPoints<kernels::Integer255>;
template class NarrowPoints<NarrowInteger>;
template class NarrowBodies<kernels::Integer127>;
template class NarrowBodies<kernels::Integer255>;
template class NarrowBodies<NarrowInteger>;

std::vector<Weight> weights_of(std::span<const Difference> differences, std::span<const mpq_class> weights,
                               std::uint32_t Difference::*side) {
  std::map<std::uint32_t, mpq_class> sums;
  for (std::size_t i = 0; i < differences.size(); ++i) sums[differences[i].*side] += weights[i];
  std::vector<Weight> result;
  for (const auto& [index, weight] : sums) result.push_back({index, weight});
  return result;
}

mpz_class support_naive(std::span<const Vector> a, std::span<const Vector> b, const Vector& u) {
  return dot(u, b[kernels::extreme_points_naive(b, u).front()] - a[kernels::extreme_points_naive(a, -u).front()]);
}

std::optional<Vec3<mpq_class>> convex_combination(std::span<const Vector> points, std::span<const Weight> weights) {
  Vec3<mpq_class> sum;
  mpq_class total;
  for (const Weight& w : weights) {
    if (w.index >= points.size() || w.weight <= 0) return std::nullopt;
    const Vector& p = points[w.index];
    total += w.weight;
    sum.x += w.weight * p.x;
    sum.y += w.weight * p.y;
    sum.z += w.weight * p.z;
  }
  return total == 1 ? std::optional(sum) : std::nullopt;
}

}  // namespace fathom::polytope
