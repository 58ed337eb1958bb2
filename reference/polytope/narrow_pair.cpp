// SPDX-License-Identifier: GPL-3.0-or-later
// From dyadic numbers to a lattice by shifts: the unit is the lowest bit that any coordinate has.
#include <algorithm>
#include <bit>
#include <limits>
#include <optional>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/filters/rounded_plane.hpp"
#include "kernels/float_environment.hpp"
#include "reference/polytope/lattice.hpp"

namespace fathom::polytope {
namespace {

std::array<const double*, 3> coordinates(const std::array<double, 3>& p) { return {p.data(), p.data() + 1, p.data() + 2}; }
std::array<const mpq_class*, 3> coordinates(const Point& p) { return {&p.x, &p.y, &p.z}; }

// The bits that coordinates have: none below 2^low, none from 2^high on.
struct Range {
  long low = 0, high = std::numeric_limits<long>::min();

  // Adds the numbers to the list. False if some number is not dyadic.
  template <class Points>
  bool cover(Points body, std::vector<kernels::Dyadic>& numbers) {
    for (const auto& p : body) {
      for (const auto* c : coordinates(p)) {
        const std::optional<kernels::Dyadic> value = kernels::dyadic(*c);
        if (!value) return false;
        numbers.push_back(*value);
        if (value->mantissa == 0) continue;
        low = std::min(low, value->exponent);
        const auto magnitude = static_cast<std::uint64_t>(value->mantissa < 0 ? -value->mantissa : value->mantissa);
        high = std::max(high, value->exponent + static_cast<long>(std::bit_width(magnitude)));
      }
    }
    return true;
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
template <class Lattice>
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

template <class Lattice>
void make_images(const std::vector<Lattice>& points, long exponent, NarrowCloud& cloud) {
  for (std::vector<double>* images : {&cloud.x, &cloud.y, &cloud.z}) images->resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.x[i] = kernels::image(points[i].x, exponent);
    cloud.y[i] = kernels::image(points[i].y, exponent);
    cloud.z[i] = kernels::image(points[i].z, exponent);
  }
}

// From `pair.numbers`, in words or in wider integers: `list` is one of a cloud's two lists.
template <class Lattice>
void fill(std::size_t size_a, long low, NarrowPair& pair, std::vector<Lattice> NarrowCloud::*list) {
  Lattice origin;
  put(&pair.numbers[3 * size_a], low, origin);
  Extent<Lattice> extent;
  const kernels::Dyadic* p = pair.numbers.data();
  for (const auto& [size, points] : {std::pair(size_a, &(pair.a.*list)), std::pair(pair.numbers.size() / 3 - size_a, &(pair.b.*list))}) {
    points->resize(size);
    for (Lattice& q : *points) {
      put(p, low, q);
      p += 3;
      q = q - origin;
      extent.cover(q.x);
      extent.cover(q.y);
      extent.cover(q.z);
    }
  }
  // The powers of two that all coordinates and the denominator share, which `place` divides out too. All coordinates may be 0.
  const unsigned shared = std::min(static_cast<unsigned>(-low), extent.trailing_zeros());
  pair.shift = static_cast<unsigned>(-low) - shared;
  pair.exponent = std::max(extent.exponent() - static_cast<long>(shared), 0L);
  for (NarrowCloud* cloud : {&pair.a, &pair.b}) {
    std::vector<Lattice>& points = cloud->*list;
    for (Lattice& p : points) {
      if (shared == 0) break;
      divide_by_power(p.x, shared);
      divide_by_power(p.y, shared);
      divide_by_power(p.z, shared);
    }
    make_images(points, pair.exponent, *cloud);
  }
}

template <class Points>
bool place(Points a, Points b, NarrowPair& pair) {
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

}  // namespace

std::vector<Point> exact_points(std::span<const std::array<double, 3>> body) {
  std::vector<Point> points;
  points.reserve(body.size());
  for (const std::array<double, 3>& p : body) points.push_back(exact_point(p));
  return points;
}

Point exact_point(const std::array<double, 3>& p) { return {exact_value(p[0]), exact_value(p[1]), exact_value(p[2])}; }

bool place_narrow(kernels::Positions a, kernels::Positions b, NarrowPair& pair) { return place(a, b, pair); }

bool place_narrow(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b, NarrowPair& pair) {
  const kernels::DefaultFloatEnvironment environment;
  return place(a, b, pair);
}

}  // namespace fathom::polytope
