// SPDX-License-Identifier: GPL-3.0-or-later
// Points in binary64 become integers times one power of two; where a pose moves them, 128 bits hold
// what they become.                                            [proofs/prepared.md, "In integers"]
#include "reference/polytope/points.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <new>

#include "fathom/numbers.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/files/pose.hpp"

namespace fathom::polytope {
namespace {

using kernels::Int128;

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

polytope::Positions Points::exact(std::vector<Point>& room) const {
  if (posed_ != nullptr) {
    room.clear();
    for (std::size_t i = 0; i < size(); ++i) room.push_back((*this)[i].exact());
    return room;
  }
  if (doubles_.empty()) return exact_;
  room = exact_points(doubles_);
  return room;
}

std::vector<Point> exact_points(std::span<const std::array<double, 3>> body) {
  std::vector<Point> points;
  points.reserve(body.size());
  for (const std::array<double, 3>& p : body) {
    // Where memory ends GMP cannot throw; operator new can, once GMP has got the last of it.
    if (points.size() % 1024 == 0) ::operator delete(::operator new(1));
    points.push_back({exact_value(p[0]), exact_value(p[1]), exact_value(p[2])});
  }
  return points;
}

}  // namespace fathom::polytope
