// SPDX-License-Identifier: GPL-3.0-or-later
// Short rationals become integers in words: odd parts of their denominators by products, powers of
// two by shifts. The unit is the lowest bit that any coordinate has, over the common divisor.
#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "kernels/filters/plane.hpp"
#include "reference/files/pose.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {
namespace {

// Takes the coordinates apart, into numbers and their divisors. False if one is too
// long, or there are too many divisors.
bool take_apart(const Points& a, const Points& b, NarrowMemory& placed) {
  placed.numbers.resize(3 * (a.size() + b.size()));
  placed.divisors.clear();
  kernels::ShortRational* next = placed.numbers.data();
  struct Take {
    NarrowMemory& placed;
    kernels::ShortRational*& next;
    bool operator()(double c) {
      *next++ = {kernels::dyadic(c)};
      return true;
    }
    bool operator()(const mpq_class& c) {
      const std::optional<kernels::ShortRational> number = kernels::short_rational(c);
      if (!number || (number->divisor != 1 && !placed.divisors.add(*number))) return false;
      *next++ = *number;
      return true;
    }
  } take{placed, next};
  return a.all_coordinates(take) && b.all_coordinates(take);
}

// Brings the numbers over the common divisor. False if one becomes too long.
bool multiply_numerators(NarrowMemory& placed, std::uint64_t common) {
  for (kernels::ShortRational& n : placed.numbers)
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
void for_each_coordinate(NarrowMemory& placed, std::vector<Vec3<NT>> NarrowCloud::*list, F f) {
  for (NarrowCloud* cloud : {&placed.a, &placed.b}) {
    for (Vec3<NT>& p : cloud->*list) {
      f(p.x);
      f(p.y);
      f(p.z);
    }
  }
}

// The points, from the numbers over one divisor: `list` is one of a cloud's two lists.
template <class NT>
void fill(std::size_t size_a, long low, std::uint64_t divisor, NarrowMemory& placed,
          std::vector<Vec3<NT>> NarrowCloud::*list) {
  (placed.a.*list).resize(size_a);
  (placed.b.*list).resize(placed.numbers.size() / 3 - size_a);
  auto number = placed.numbers.begin();
  for_each_coordinate(placed, list, [&](NT& c) { put(*number++, low, c); });
  const Vec3<NT> origin = (placed.b.*list).front();
  for (NarrowCloud* cloud : {&placed.a, &placed.b})
    for (Vec3<NT>& p : cloud->*list) p = p - origin;

  // What all share goes into the unit: a power of two, and what divides the divisor.
  unsigned zeros = std::numeric_limits<unsigned>::max();
  std::uint64_t shared = divisor;
  for_each_coordinate(placed, list, [&](const NT& c) {
    if (c == NT(0)) return;
    zeros = std::min(zeros, trailing_zeros(c));
    if (shared != 1) shared = shared_with(c, shared);
  });
  const bool all_zero = zeros == std::numeric_limits<unsigned>::max();
  placed.power = all_zero ? 0 : low + static_cast<long>(zeros);
  placed.denominator = divisor / shared;
  if (!all_zero && (zeros > 0 || shared > 1))
    for_each_coordinate(placed, list, [&](NT& c) { divide(c, shared, zeros); });
}

void clear_points(NarrowMemory& placed) {
  for (NarrowCloud* cloud : {&placed.a, &placed.b}) {
    cloud->words.clear();
    cloud->points.clear();
  }
}

// Turns the points into words, which they fit.
void shorten(NarrowMemory& placed) {
  for (NarrowCloud* cloud : {&placed.a, &placed.b}) {
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

/// Sets what follows from the points, which are in one form in both clouds: the exponent, words if
/// all coordinates fit them (of differences they may where those of points do not), the images.
void set_images(NarrowMemory& placed) {
  const auto set_exponent = [&](auto list) {
    placed.exponent = 0;
    for_each_coordinate(placed, list,
                        [&](const auto& c) { placed.exponent = std::max(placed.exponent, exponent_of(c)); });
  };
  if (placed.b.words.empty()) set_exponent(&NarrowCloud::points);
  else set_exponent(&NarrowCloud::words);
  if (placed.b.words.empty() && placed.exponent < most_word_bits) shorten(placed);
  for (NarrowCloud* cloud : {&placed.a, &placed.b})
    if (cloud->points.empty()) make_images(cloud->words, placed.exponent, *cloud);
    else make_images(cloud->points, placed.exponent, *cloud);
}

using kernels::Int128;
using kernels::Uint128;

Uint128 magnitude(Int128 n) { return static_cast<Uint128>(n < 0 ? -n : n); }

int trailing_zeros(Uint128 n) {
  const auto half = static_cast<std::uint64_t>(n);
  return half != 0 ? std::countr_zero(half) : 64 + std::countr_zero(static_cast<std::uint64_t>(n >> 64));
}

// Places points that poses move, both in numerators. False if these have too many bits over one
// power of two.
bool place_numerators(const PosedPoints& a, const PosedPoints& b, NarrowMemory& placed) {
  const long low = std::min(a.exponent, b.exponent);
  const auto fits = [&](const PosedPoints& body) {
    Uint128 all = 0;
    for (const Vec3<Int128>& p : body.numerators) all |= magnitude(p.x) | magnitude(p.y) | magnitude(p.z);
    return kernels::bit_length(all) + body.exponent - low <= PosedPoints::most_bits;
  };
  if (!fits(a) || !fits(b)) return false;
  const auto from_origin = [&](const Vec3<Int128>& p, long shift) {
    const Vec3<Int128>& origin = b.numerators.front();
    const long of_b = b.exponent - low;
    return Vec3<Int128>{(p.x << shift) - (origin.x << of_b), (p.y << shift) - (origin.y << of_b),
                        (p.z << shift) - (origin.z << of_b)};
  };
  Uint128 all = 0;
  for (const PosedPoints* body : {&a, &b})
    for (const Vec3<Int128>& p : body->numerators) {
      const Vec3<Int128> d = from_origin(p, body->exponent - low);
      all |= magnitude(d.x) | magnitude(d.y) | magnitude(d.z);
    }
  const int zeros = all == 0 ? 0 : trailing_zeros(all);
  const bool words = kernels::bit_length(all) - zeros <= most_word_bits;
  placed.denominator = 1;
  placed.power = all == 0 ? 0 : low + zeros;
  clear_points(placed);
  for (const auto& [cloud, body] : {std::pair(&placed.a, &a), std::pair(&placed.b, &b)}) {
    for (const Vec3<Int128>& p : body->numerators) {
      const Vec3<Int128> d = from_origin(p, body->exponent - low);
      const auto word = [&](Int128 n) { return static_cast<std::int64_t>(n >> zeros); };
      const auto narrow = [&](Int128 n) {
        const Uint128 m = magnitude(n >> zeros);
        const mp_limb_t limbs[2] = {static_cast<mp_limb_t>(m), static_cast<mp_limb_t>(m >> 64)};
        return NarrowCoordinate::of_limbs(limbs, 2, n < 0);
      };
      if (words) cloud->words.push_back({word(d.x), word(d.y), word(d.z)});
      else cloud->points.push_back({narrow(d.x), narrow(d.y), narrow(d.z)});
    }
  }
  set_images(placed);
  return true;
}

}  // namespace

bool place_narrow(const Points& a, const Points& b, NarrowMemory& placed) {
  if (a.empty() || b.empty()) return false;
  const bool posed = a.posed() != nullptr && b.posed() != nullptr;
  if (posed && !a.posed()->numerators.empty() && !b.posed()->numerators.empty())
    return place_numerators(*a.posed(), *b.posed(), placed);
  if (!take_apart(a, b, placed)) return false;
  const std::optional<std::uint64_t> divisor = placed.divisors.common(most_word_bits);
  if (!divisor || !placed.divisors.in_lowest_terms()) return false;
  if (*divisor != 1 && !multiply_numerators(placed, *divisor)) return false;
  const Range range(placed.numbers);
  const long bits = range.high - range.low + 1;  // of the differences from the origin
  if (bits > most_narrow_bits) return false;
  clear_points(placed);
  if (bits <= most_word_bits) fill(a.size(), range.low, *divisor, placed, &NarrowCloud::words);
  else fill(a.size(), range.low, *divisor, placed, &NarrowCloud::points);
  set_images(placed);
  return true;
}

bool place_over_common_denominator(const PosedPoints& a, const PosedPoints& b, NarrowMemory& placed) {
  if (a.integers == nullptr || b.integers == nullptr) return false;
  const Pose pose_a = files::exact_pose(*a.pose), pose_b = files::exact_pose(*b.pose);
  mpz_class common = 1;
  for (const Pose* pose : {&pose_a, &pose_b})
    for (const auto& row : *pose)
      for (const mpq_class& x : row) common = lcm(common, x.get_den());
  const long shift = std::max(0L, -std::min(a.integers->exponent, b.integers->exponent));
  if (kernels::bit_length(common) + shift > most_narrow_bits) return false;
  const auto moved = [&](const PosedPoints& body, const Pose& pose) {
    std::array<std::array<mpz_class, 4>, 3> matrix;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        matrix[i][j] = pose[i][j].get_num() * (common / pose[i][j].get_den());
        matrix[i][j] <<= static_cast<mp_bitcnt_t>(j < 3 ? body.integers->exponent + shift : shift);
      }
    std::vector<Vector> result;
    result.reserve(body.size());
    for (std::size_t k = 0; k < body.size(); ++k) {
      const std::int64_t* p = &body.integers->integers[3 * body.index(k)];
      const auto coordinate = [&](std::size_t i) {
        return mpz_class(matrix[i][0] * p[0] + matrix[i][1] * p[1] + matrix[i][2] * p[2] + matrix[i][3]);
      };
      result.push_back({coordinate(0), coordinate(1), coordinate(2)});
    }
    return result;
  };
  std::vector<Vector> points_a = moved(a, pose_a), points_b = moved(b, pose_b);
  const Vector origin = points_b.front();
  for (std::vector<Vector>* points : {&points_a, &points_b})
    for (Vector& p : *points) p = p - origin;
  if (std::max(kernels::binary_exponent(points_a), kernels::binary_exponent(points_b)) > most_narrow_bits) return false;
  placed.denominator = common << static_cast<mp_bitcnt_t>(shift);
  placed.power = 0;
  clear_points(placed);
  for (const auto& [cloud, points] : {std::pair(&placed.a, &points_a), std::pair(&placed.b, &points_b)})
    for (const Vector& p : *points)
      cloud->points.push_back({NarrowCoordinate(p.x), NarrowCoordinate(p.y), NarrowCoordinate(p.z)});
  set_images(placed);
  return true;
}

PlacedPair widened(const NarrowMemory& placed, Point origin) {
  const auto power = static_cast<unsigned>(std::max(placed.power, 0L));
  const auto points_of = [&](const NarrowCloud& cloud) {
    std::vector<Vector> points;
    points.reserve(cloud.x.size());
    for (const Vec3<std::int64_t>& p : cloud.words) points.push_back({p.x, p.y, p.z});
    for (const Vec3<NarrowCoordinate>& p : cloud.points) points.push_back(to_vector(p));
    if (power > 0)
      for (Vector& p : points) p = {p.x << power, p.y << power, p.z << power};
    return points;
  };
  return place_integers(points_of(placed.a), points_of(placed.b), placed.denominator << std::max(-placed.power, 0L),
                        std::move(origin));
}

template <class Integer>
const std::vector<std::uint32_t>& PointsIn<Integer>::extreme(const Vec3<Integer>& u) const {
  const kernels::DirectionImage v = kernels::direction_image_for(u, exponent_);
  kernels::near_extreme(images_, v, *memory_);
  std::vector<std::uint32_t>& near = memory_->near;
  if (near.size() > 1 && v.slack != 0)
    kernels::keep_greatest<Integer>(near, [&](Integer& value, std::uint32_t i) { value = dot(u, (*this)[i]); });
  return near;
}

template class PointsIn<kernels::Integer127>;
template class PointsIn<kernels::Integer255>;
template class PointsIn<NarrowInteger>;

}  // namespace fathom::polytope
