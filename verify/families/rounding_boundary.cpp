// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <utility>

#include "kernels/vector.hpp"
#include "verify/families/polytope_pairs.hpp"

namespace fathom::families {

namespace {

/// A point where rounding changes: `whole` units, and perhaps half a unit more.
struct Boundary {
  mpz_class whole;
  bool halfway;
  long unit;  ///< an ulp is 2^unit
  [[nodiscard]] mpq_class value() const { return times_power_of_two(2 * mpq_class(whole) + (halfway ? 1 : 0), unit - 1); }
};

Boundary at_the_ends(const FloatFormat& format, Random& random) {
  const mpz_class least = 1, full = (mpz_class(1) << format.digits) - 1, normal = mpz_class(1) << (format.digits - 1);
  const long low = format.least_exponent - format.digits + 1, high = format.greatest_exponent - format.digits + 1;
  switch (random.between(0, 5)) {
    case 0: return {0, true, low};  // half of the least subnormal number
    case 1: return {least, true, low};
    case 2: return {mpz_class(normal - 1), true, low};  // between the greatest subnormal number and the least normal one
    case 3: return {normal, false, low};
    case 4: return {full, false, high};  // the greatest number
    default: return {full, true, high};  // from here on rn gives infinity
  }
}

Boundary boundary(const FloatFormat& format, Random& random) {
  if (random.between(0, 7) == 0) return at_the_ends(format, random);
  const long exponent = random.between(-20, 20);
  const std::int64_t first = std::int64_t{1} << (format.digits - 1);
  const bool last = random.between(0, 7) == 0;  // next to a power of 2
  const std::int64_t whole = last ? 2 * first - 1 : random.between(first, 2 * first - 1);
  return {whole, random.coin(), exponent - format.digits + 1};
}

Lenses along_an_axis(const Boundary& b, int side, Random& random) {
  const long k = random.between(1, 50);
  const mpq_class step = times_power_of_two(1, b.unit);
  const mpq_class offset = step * ((b.halfway ? ratio(1, 2) : mpq_class(0)) + side * times_power_of_two(1, -k));
  constexpr std::array<std::array<int, 3>, 6> axes{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  const std::array<int, 3>& axis = axes[static_cast<std::size_t>(random.between(0, 5))];
  Lenses result{{axis[0], axis[1], axis[2]}, random_meeting(random), random_meeting(random), {}, {}, {}, {}};
  result.b_top = step * b.whole;
  result.a_bottom = -offset;
  return result;
}

/// Integer vectors of integer length.
Vector direction_of_integer_length(Random& random) {
  constexpr std::array<std::array<int, 3>, 8> some{
      {{1, 2, 2}, {2, 3, 6}, {1, 4, 8}, {4, 4, 7}, {2, 6, 9}, {6, 6, 7}, {3, 4, 12}, {2, 5, 14}}};
  std::array<int, 3> v = some[static_cast<std::size_t>(random.between(0, 7))];
  std::swap(v[0], v[static_cast<std::size_t>(random.between(0, 2))]);
  for (int& x : v) x = random.coin() ? x : -x;
  return {v[0], v[1], v[2]};
}

/// With a distance from the boundary of 3/4 * 2^-k ulp, up to a small fraction of that.
Lenses in_any_direction(const Boundary& b, int side, Random& random) {
  const long k = random.between(1, 200);
  const Vector n = side == 0 ? direction_of_integer_length(random) : random_integer_direction(random, 40);
  Lenses result{n, random_meeting(random), random_meeting(random), {}, {}, {}, {}};
  const mpq_class depth = b.value() + side * times_power_of_two(ratio(3, 4), b.unit - k), length_squared(dot(n, n));
  if (side == 0) {
    const mpz_class length = sqrt(mpz_class(dot(n, n)));
    result.b_top = depth / length;
  } else {
    result.b_top = quotient_of_roots(mpq_class(depth * depth), length_squared, k - b.unit + 16);  // |n| < 2^7
  }
  result.a_bottom = 0;
  return result;
}

}  // namespace

Bodies rounding_boundary(const FloatFormat& format, Random& random, unsigned n) {
  const Boundary b = boundary(format, random);
  const bool below_smallest = b.whole == 0;  // half of the least number has no number below it but 0
  const int side = static_cast<int>(random.between(-1, 1));
  const bool axis = random.coin() && !below_smallest;
  Lenses plan = axis ? along_an_axis(b, side, random) : in_any_direction(b, side, random);
  // The way out in direction -n is longer by six percent at least.
  const mpq_class height = plan.b_top - plan.a_bottom;
  const long log = binary_logarithm(height);
  plan.b_bottom = times_power_of_two(1, log - 3);
  plan.a_top = plan.b_bottom + quotient_of_roots(mpq_class(height * height), 1, 10 - log) + times_power_of_two(1, log - 3);
  return lenses(plan, random, n);
}

}  // namespace fathom::families
