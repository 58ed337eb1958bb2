// SPDX-License-Identifier: GPL-3.0-or-later
// Short rationals become integers in words: odd parts of their denominators by products, powers of
// two by shifts. The unit is the lowest bit that any coordinate has, over the common divisor.
#include "reference/polytope/narrow_lattice.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace fathom::polytope {
namespace {

// Takes the coordinates apart, into the numbers and the divisors of the pair. False if one is too
// long, or there are too many divisors.
bool take_apart(const Points& a, const Points& b, NarrowPair& pair) {
  pair.numbers.resize(3 * (a.size() + b.size()));
  pair.divisors.clear();
  kernels::ShortRational* next = pair.numbers.data();
  struct Take {
    NarrowPair& pair;
    kernels::ShortRational*& next;
    bool operator()(double c) {
      *next++ = {kernels::dyadic(c)};
      return true;
    }
    bool operator()(const mpq_class& c) {
      const std::optional<kernels::ShortRational> number = kernels::short_rational(c);
      if (!number || (number->divisor != 1 && !pair.divisors.add(*number))) return false;
      *next++ = *number;
      return true;
    }
  } take{pair, next};
  return a.all_coordinates(take) && b.all_coordinates(take);
}

// Brings the numbers over the common divisor. False if one becomes too long.
bool multiply_numerators(NarrowPair& pair, std::uint64_t common) {
  for (kernels::ShortRational& n : pair.numbers)
    if (__builtin_mul_overflow(n.mantissa, static_cast<std::int64_t>(common / n.divisor), &n.mantissa) ||
        n.mantissa == std::numeric_limits<std::int64_t>::min())
      return false;
  return true;
}

// The bits that numerators have: none below 2^low, none from 2^high on.
struct Range {
  long low = 0, high = 0;

  explicit Range(const std::vector<kernels::ShortRational>& numbers) {
    bool found = false;
    for (const kernels::ShortRational& n : numbers) {
      if (n.mantissa == 0) continue;
      const auto magnitude = static_cast<std::uint64_t>(std::abs(n.mantissa));
      const long top = n.exponent + static_cast<long>(std::bit_width(magnitude));
      low = found ? std::min(low, n.exponent) : n.exponent;
      high = found ? std::max(high, top) : top;
      found = true;
    }
  }
};

// What the coordinates of points on a narrow lattice are asked, in both forms.

void put(const kernels::ShortRational& n, long low, std::int64_t& c) {
  c = n.mantissa == 0 ? 0 : n.mantissa << (n.exponent - low);
}
void put(const kernels::ShortRational& n, long low, NarrowCoordinate& c) {
  c = NarrowCoordinate::shifted(n.mantissa, n.mantissa == 0 ? 0 : static_cast<unsigned>(n.exponent - low));
}
// Not of 0.
unsigned trailing_zeros(std::int64_t c) {
  return static_cast<unsigned>(std::countr_zero(static_cast<std::uint64_t>(c)));
}
unsigned trailing_zeros(const NarrowCoordinate& c) { return c.trailing_zeros(); }
std::uint64_t shared_with(std::int64_t c, std::uint64_t divisor) {
  return std::gcd(static_cast<std::uint64_t>(std::abs(c)), divisor);
}
std::uint64_t shared_with(const NarrowCoordinate& c, std::uint64_t divisor) {
  mpz_t n;
  c.view(n);
  return mpz_gcd_ui(nullptr, n, divisor);
}
void divide(std::int64_t& c, std::uint64_t divisor, unsigned power) {
  c = (c >> power) / static_cast<std::int64_t>(divisor);
}
void divide(NarrowCoordinate& c, std::uint64_t divisor, unsigned power) {
  c.divide_by_power(power);
  if (divisor != 1) c.divide_by(divisor);
}
// The least e >= 0 with |c| <= 2^e.
long exponent_of(std::int64_t c) { return c == 0 ? 0 : std::bit_width(static_cast<std::uint64_t>(std::abs(c)) - 1); }
long exponent_of(const NarrowCoordinate& c) { return kernels::binary_exponent(c); }

template <class NT, class F>
void for_each_coordinate(NarrowPair& pair, std::vector<Vec3<NT>> NarrowCloud::*list, F f) {
  for (NarrowCloud* cloud : {&pair.a, &pair.b}) {
    for (Vec3<NT>& p : cloud->*list) {
      f(p.x);
      f(p.y);
      f(p.z);
    }
  }
}

// The points, from the numbers over one divisor: `list` is one of a cloud's two lists.
template <class NT>
void fill(std::size_t size_a, long low, std::uint64_t divisor, NarrowPair& pair,
          std::vector<Vec3<NT>> NarrowCloud::*list) {
  (pair.a.*list).resize(size_a);
  (pair.b.*list).resize(pair.numbers.size() / 3 - size_a);
  auto number = pair.numbers.begin();
  for_each_coordinate(pair, list, [&](NT& c) { put(*number++, low, c); });
  const Vec3<NT> origin = (pair.b.*list).front();
  for (NarrowCloud* cloud : {&pair.a, &pair.b})
    for (Vec3<NT>& p : cloud->*list) p = p - origin;

  // What all share goes into the unit: a power of two, and what divides the divisor.
  unsigned zeros = std::numeric_limits<unsigned>::max();
  std::uint64_t shared = divisor;
  for_each_coordinate(pair, list, [&](const NT& c) {
    if (c == NT(0)) return;
    zeros = std::min(zeros, trailing_zeros(c));
    if (shared != 1) shared = shared_with(c, shared);
  });
  const bool all_zero = zeros == std::numeric_limits<unsigned>::max();
  pair.power = all_zero ? 0 : low + static_cast<long>(zeros);
  pair.divisor = divisor / shared;
  if (!all_zero && (zeros > 0 || shared > 1)) for_each_coordinate(pair, list, [&](NT& c) { divide(c, shared, zeros); });
}

void clear_points(NarrowPair& pair) {
  for (NarrowCloud* cloud : {&pair.a, &pair.b}) {
    cloud->words.clear();
    cloud->points.clear();
  }
}

// Turns the points into words, which they fit.
void shorten(NarrowPair& pair) {
  for (NarrowCloud* cloud : {&pair.a, &pair.b}) {
    for (const Vec3<NarrowCoordinate>& p : cloud->points)
      cloud->words.push_back({p.x.to_word(), p.y.to_word(), p.z.to_word()});
    cloud->points.clear();
  }
}

template <class NT>
void make_images(const std::vector<Vec3<NT>>& points, long exponent, NarrowCloud& cloud) {
  for (std::vector<double>* images : {&cloud.x, &cloud.y, &cloud.z}) images->resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.x[i] = kernels::image(points[i].x, exponent);
    cloud.y[i] = kernels::image(points[i].y, exponent);
    cloud.z[i] = kernels::image(points[i].z, exponent);
  }
}

}  // namespace

void set_images(NarrowPair& pair) {
  const auto set_exponent = [&](auto list) {
    pair.exponent = 0;
    for_each_coordinate(pair, list, [&](const auto& c) { pair.exponent = std::max(pair.exponent, exponent_of(c)); });
  };
  if (pair.b.words.empty()) set_exponent(&NarrowCloud::points);
  else set_exponent(&NarrowCloud::words);
  if (pair.b.words.empty() && pair.exponent < most_word_bits) shorten(pair);
  for (NarrowCloud* cloud : {&pair.a, &pair.b})
    if (cloud->points.empty()) make_images(cloud->words, pair.exponent, *cloud);
    else make_images(cloud->points, pair.exponent, *cloud);
}

bool place_narrow(const Points& a, const Points& b, NarrowPair& pair) {
  if (a.empty() || b.empty()) return false;
  const bool posed = a.posed() != nullptr && b.posed() != nullptr;
  if (posed && !a.posed()->numerators.empty() && !b.posed()->numerators.empty())
    return place_numerators(*a.posed(), *b.posed(), pair);
  if (!take_apart(a, b, pair)) return false;
  const std::optional<std::uint64_t> divisor = pair.divisors.common(most_word_bits);
  if (!divisor || !pair.divisors.in_lowest_terms()) return false;
  if (*divisor != 1 && !multiply_numerators(pair, *divisor)) return false;
  const Range range(pair.numbers);
  const long bits = range.high - range.low + 1;  // of the differences from the origin
  if (bits > most_narrow_bits) return false;
  clear_points(pair);
  if (bits <= most_word_bits) fill(a.size(), range.low, *divisor, pair, &NarrowCloud::words);
  else fill(a.size(), range.low, *divisor, pair, &NarrowCloud::points);
  set_images(pair);
  return true;
}

bool narrow(const PlacedPair& placed, NarrowPair& pair) {
  if (!narrow(placed.a, placed.b, pair)) return false;
  const mp_bitcnt_t halvings = mpz_scan1(placed.denominator.get_mpz_t(), 0);
  pair.divisor = placed.denominator >> halvings;
  pair.power = -static_cast<long>(halvings);
  return true;
}

bool narrow(const kernels::PointCloud& a, const kernels::PointCloud& b, NarrowPair& pair) {
  if (a.exponent() > most_narrow_bits) return false;
  pair.divisor = 1;
  pair.power = 0;
  pair.exponent = a.exponent();
  clear_points(pair);
  for (const auto& [cloud, wide] : {std::pair(&pair.a, &a), std::pair(&pair.b, &b)}) {
    for (const Vector& p : wide->points())
      cloud->points.push_back({NarrowCoordinate(p.x), NarrowCoordinate(p.y), NarrowCoordinate(p.z)});
    cloud->x.assign(wide->xs().begin(), wide->xs().end());
    cloud->y.assign(wide->ys().begin(), wide->ys().end());
    cloud->z.assign(wide->zs().begin(), wide->zs().end());
  }
  if (pair.exponent < most_word_bits) shorten(pair);
  return true;
}

namespace {

// How many units of `place` are one of the input, and the power of two by which its unit is finer.
mpz_class units_of(const NarrowPair& pair) { return pair.divisor << std::max(-pair.power, 0L); }
unsigned finer_by(const NarrowPair& pair) { return static_cast<unsigned>(std::max(pair.power, 0L)); }

}  // namespace

PlacedPair widened(const NarrowPair& pair, Point origin) {
  const unsigned power = finer_by(pair);
  const auto cloud = [&](const NarrowCloud& narrow) {
    std::vector<Vector> points;
    points.reserve(narrow.x.size());
    for (const Vec3<std::int64_t>& p : narrow.words) points.push_back({p.x, p.y, p.z});
    for (const Vec3<NarrowCoordinate>& p : narrow.points) points.push_back(to_vector(p));
    if (power > 0)
      for (Vector& p : points) p = {p.x << power, p.y << power, p.z << power};
    return kernels::PointCloud(std::move(points), pair.exponent + power);
  };
  return {units_of(pair), std::move(origin), cloud(pair.a), cloud(pair.b)};
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
mpq_class NarrowBodies<Integer>::unit() const {
  return {mpz_class(1) << finer_by(pair_), units_of(pair_)};
}

template <class Integer>
mpq_class NarrowBodies<Integer>::in_units(const Integer& n) const {
  mpq_class q;
  if (sgn(n) == 0) return q;
  mpz_class &numerator = q.get_num(), &denominator = q.get_den();
  numerator = to_mpz(n);
  const long below = std::min<long>(-pair_.power, mpz_scan1(numerator.get_mpz_t(), 0));
  if (below < 0) numerator <<= -below;
  else mpz_tdiv_q_2exp(numerator.get_mpz_t(), numerator.get_mpz_t(), below);
  if (pair_.divisor != 1) {
    const mpz_class shared = gcd(numerator, pair_.divisor);
    mpz_divexact(numerator.get_mpz_t(), numerator.get_mpz_t(), shared.get_mpz_t());
    mpz_divexact(denominator.get_mpz_t(), pair_.divisor.get_mpz_t(), shared.get_mpz_t());
  }
  denominator <<= -pair_.power - below;
  return q;
}

template <class Integer>
mpz_class NarrowBodies<Integer>::units() const {
  return units_of(pair_);
}

template class NarrowPoints<kernels::Integer127>;
template class NarrowPoints<kernels::Integer255>;
template class NarrowPoints<NarrowInteger>;
template class NarrowBodies<kernels::Integer127>;
template class NarrowBodies<kernels::Integer255>;
template class NarrowBodies<NarrowInteger>;

}  // namespace fathom::polytope
