// SPDX-License-Identifier: GPL-3.0-or-later
// From dyadic numbers to a lattice by shifts: the unit is the lowest bit that any coordinate has.
#include "reference/polytope/narrow_pair.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "fathom/numbers.hpp"
#include "kernels/filters/fixed_images.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/dyadic.hpp"

namespace fathom::polytope {
namespace {

std::array<const double*, 3> coordinates(const std::array<double, 3>& p) { return {p.data(), p.data() + 1, p.data() + 2}; }
std::array<const mpq_class*, 3> coordinates(const Point& p) { return {&p.x, &p.y, &p.z}; }

// The bits that coordinates have: none below 2^low, none from 2^high on.
struct Range {
  long low = 0, high = std::numeric_limits<long>::min();

  // False if some number is not dyadic.
  template <class P>
  bool cover(std::span<const P> body) {
    for (const P& p : body) {
      for (const auto* c : coordinates(p)) {
        const std::optional<kernels::Dyadic> value = kernels::dyadic(*c);
        if (!value) return false;
        if (value->mantissa == 0) continue;
        low = std::min(low, value->exponent);
        const auto magnitude = static_cast<std::uint64_t>(value->mantissa < 0 ? -value->mantissa : value->mantissa);
        high = std::max(high, value->exponent + static_cast<long>(std::bit_width(magnitude)));
      }
    }
    return true;
  }
};

kernels::Dyadic taken_apart(double c) { return kernels::dyadic(c); }
kernels::Dyadic taken_apart(const mpq_class& c) { return *kernels::dyadic(c); }

// The point in units of 2^low.
template <class P>
void put(const P& p, long low, Vec3<std::int64_t>& q) {
  const auto at = [&](const auto* c) {
    const kernels::Dyadic value = taken_apart(*c);
    return value.mantissa == 0 ? 0 : value.mantissa << (value.exponent - low);
  };
  const auto [x, y, z] = coordinates(p);
  q = {at(x), at(y), at(z)};
}
template <class P>
void put(const P& p, long low, Vec3<NarrowCoordinate>& q) {
  const auto at = [&](const auto* c) {
    const kernels::Dyadic value = taken_apart(*c);
    return NarrowCoordinate::shifted(value.mantissa, value.mantissa == 0 ? 0 : static_cast<unsigned>(value.exponent - low));
  };
  const auto [x, y, z] = coordinates(p);
  q = {at(x), at(y), at(z)};
}

bool is_zero(std::int64_t c) { return c == 0; }
bool is_zero(const NarrowCoordinate& c) { return sgn(c) == 0; }

unsigned trailing_zeros(std::int64_t c) { return static_cast<unsigned>(std::countr_zero(static_cast<std::uint64_t>(c))); }
unsigned trailing_zeros(const NarrowCoordinate& c) { return c.trailing_zeros(); }

void divide_by_power(std::int64_t& c, unsigned shift) { c >>= shift; }
void divide_by_power(NarrowCoordinate& c, unsigned shift) { c.divide_by_power(shift); }

// The least e >= 0 with |c| <= 2^e.
long binary_exponent(std::int64_t c) {
  const std::uint64_t magnitude = c < 0 ? -static_cast<std::uint64_t>(c) : static_cast<std::uint64_t>(c);
  return magnitude == 0 ? 0 : std::bit_width(magnitude - 1);
}
long binary_exponent(const NarrowCoordinate& c) { return kernels::binary_exponent(c); }

// The same in words or in wider integers: `of` returns one of a cloud's two lists.
template <class P, class Of>
void fill(std::span<const P> a, std::span<const P> b, long low, NarrowPair& pair, Of of) {
  auto &of_a = of(pair.a), &of_b = of(pair.b);
  using Lattice = typename std::remove_reference_t<decltype(of_a)>::value_type;
  Lattice origin, q;
  put(b.front(), low, origin);
  const auto for_each_coordinate = [&](auto f) {
    for (auto* points : {&of_a, &of_b})
      for (Lattice& p : *points) f(p.x), f(p.y), f(p.z);
  };
  for (auto [body, points] : {std::pair(a, &of_a), std::pair(b, &of_b)}) {
    for (const P& p : body) {
      put(p, low, q);
      points->push_back(q - origin);
    }
  }
  // The powers of two that all coordinates and the denominator share, which `place` divides out too.
  auto shared = static_cast<unsigned>(-low);
  for_each_coordinate([&](const auto& c) {
    if (shared > 0 && !is_zero(c)) shared = std::min(shared, trailing_zeros(c));
  });
  pair.shift = static_cast<unsigned>(-low) - shared;
  pair.exponent = 0;
  for_each_coordinate([&](auto& c) {
    if (shared > 0) divide_by_power(c, shared);
    pair.exponent = std::max(pair.exponent, binary_exponent(c));
  });
  for (NarrowCloud* cloud : {&pair.a, &pair.b}) {
    for (const Lattice& p : of(*cloud)) {
      cloud->x.push_back(kernels::image(p.x, pair.exponent));
      cloud->y.push_back(kernels::image(p.y, pair.exponent));
      cloud->z.push_back(kernels::image(p.z, pair.exponent));
    }
  }
}

template <class P>
bool place(std::span<const P> a, std::span<const P> b, NarrowPair& pair) {
  Range range;
  if (a.empty() || b.empty() || !range.cover(a) || !range.cover(b)) return false;
  const long bits = std::max(range.high, range.low) - range.low + 1;  // of the differences from the origin
  if (bits > most_narrow_bits) return false;
  for (NarrowCloud* cloud : {&pair.a, &pair.b}) {
    cloud->words.clear();
    cloud->points.clear();
    for (std::vector<double>* images : {&cloud->x, &cloud->y, &cloud->z}) images->clear();
  }
  if (bits <= most_word_bits)
    fill(
        a, b, range.low, pair, [](NarrowCloud & cloud) -> auto& { return cloud.words; });
  else
    fill(
        a, b, range.low, pair, [](NarrowCloud & cloud) -> auto& { return cloud.points; });
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

bool place_narrow(std::span<const Point> a, std::span<const Point> b, NarrowPair& pair) { return place(a, b, pair); }

bool place_narrow(std::span<const std::array<double, 3>> a, std::span<const std::array<double, 3>> b, NarrowPair& pair) {
  const kernels::DefaultFloatEnvironment environment;
  return place(a, b, pair);
}

}  // namespace fathom::polytope
