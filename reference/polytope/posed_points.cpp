// SPDX-License-Identifier: GPL-3.0-or-later
// Points that a pose moves, on a narrow lattice: in 128 bits where all is in binary64 and of
// similar sizes, else over the common denominator of two matrices of rationals.
//                                                            [proofs/prepared.md, "In integers"]
#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <utility>

#include "kernels/number/rational.hpp"
#include "reference/files/pose.hpp"
#include "reference/polytope/lattice.hpp"
#include "reference/polytope/narrow_lattice.hpp"

namespace fathom::polytope {

namespace {

long bits_of(const kernels::Dyadic& number) {
  return std::bit_width(static_cast<std::uint64_t>(std::abs(number.mantissa)));
}

}  // namespace

std::optional<AlignedNumbers> aligned(std::span<const double> numbers) {
  long low = std::numeric_limits<long>::max(), high = std::numeric_limits<long>::min();
  for (const double x : numbers) {
    const kernels::Dyadic number = kernels::dyadic(x);
    if (number.mantissa == 0) continue;
    low = std::min(low, number.exponent);
    high = std::max(high, number.exponent + bits_of(number));
  }
  if (low > high) return AlignedNumbers{std::vector<std::int64_t>(numbers.size(), 0)};
  if (high - low > most_word_bits) return std::nullopt;
  AlignedNumbers result{{}, low, high - low};
  result.integers.reserve(numbers.size());
  for (const double x : numbers) {
    const kernels::Dyadic number = kernels::dyadic(x);
    result.integers.push_back(number.mantissa == 0 ? 0 : number.mantissa << (number.exponent - low));
  }
  return result;
}

GivenPoint PosedPoints::point(std::size_t i) const {
  const auto* const binary64 = std::get_if<PoseBinary64>(pose);
  if (binary64 != nullptr && given->in_binary64()) return {MovedPoint{given->binary64()[index(i)], *binary64}};
  return {files::placed(given->exact()[index(i)], files::exact_pose(*pose))};
}

namespace {

using kernels::Int128;
using kernels::Uint128;

Uint128 magnitude(Int128 n) { return static_cast<Uint128>(n < 0 ? -n : n); }

int trailing_zeros(Uint128 n) {
  const auto half = static_cast<std::uint64_t>(n);
  return half != 0 ? std::countr_zero(half) : 64 + std::countr_zero(static_cast<std::uint64_t>(n >> 64));
}

}  // namespace

void PosedPoints::move() {
  numerators.clear();
  const auto* const binary64 = std::get_if<PoseBinary64>(pose);
  if (binary64 == nullptr || integers == nullptr) {
    files::require_numbers(*pose);
    return;
  }
  std::array<double, 9> linear;
  std::array<kernels::Dyadic, 3> shift;
  for (std::size_t i = 0; i < 3; ++i) {
    std::copy_n((*binary64)[i].begin(), 3, linear.begin() + 3 * static_cast<std::ptrdiff_t>(i));
    shift[i] = kernels::dyadic((*binary64)[i][3]);
  }
  const std::optional<AlignedNumbers> matrix = aligned(linear);
  if (!matrix) return;
  const long unit = integers->exponent + matrix->exponent;
  exponent = unit;
  for (const kernels::Dyadic& t : shift)
    if (t.mantissa != 0) exponent = std::min(exponent, t.exponent);
  const long finer = unit - exponent;
  if (integers->bits + matrix->bits + 2 + finer >= most_bits) return;
  std::array<Int128, 3> offset{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (shift[i].mantissa == 0) continue;
    if (bits_of(shift[i]) + shift[i].exponent - exponent >= most_bits - 1) return;
    offset[i] = static_cast<Int128>(shift[i].mantissa) << (shift[i].exponent - exponent);
  }
  numerators.reserve(size());
  for (std::size_t k = 0; k < size(); ++k) {
    const std::int64_t* p = &integers->integers[3 * index(k)];
    const auto coordinate = [&](std::size_t i) {
      const std::int64_t* row = &matrix->integers[3 * i];
      const Int128 sum =
          static_cast<Int128>(row[0]) * p[0] + static_cast<Int128>(row[1]) * p[1] + static_cast<Int128>(row[2]) * p[2];
      return (sum << finer) + offset[i];
    };
    numerators.push_back({coordinate(0), coordinate(1), coordinate(2)});
  }
}

bool place_numerators(const PosedPoints& a, const PosedPoints& b, NarrowPair& pair) {
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
  pair.divisor = 1;
  pair.power = all == 0 ? 0 : low + zeros;
  for (const auto& [cloud, body] : {std::pair(&pair.a, &a), std::pair(&pair.b, &b)}) {
    cloud->words.clear();
    cloud->points.clear();
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
  set_images(pair);
  return true;
}

bool place_over_common_denominator(const PosedPoints& a, const PosedPoints& b, NarrowPair& pair) {
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
  PlacedPair placed = place_integers(std::move(points_a), std::move(points_b));
  placed.denominator = common << static_cast<mp_bitcnt_t>(shift);
  return narrow(placed, pair);
}

}  // namespace fathom::polytope
