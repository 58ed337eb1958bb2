// SPDX-License-Identifier: GPL-3.0-or-later
// Integer vectors for property tests: small ones, so that signs vanish often; large ones; and ones
// whose components differ by hundreds of binary orders.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "kernels/vector.hpp"
#include "tests/support/property.hpp"

namespace fathom {

inline std::ostream& operator<<(std::ostream& out, const Vector& v) {
  return out << '(' << v.x << ", " << v.y << ", " << v.z << ')';
}

}  // namespace fathom

namespace fathom::testing {

inline mpz_class power_of_two(unsigned long exponent) {
  mpz_class r = 1;
  r <<= exponent;
  return r;
}

/// |result| < 2^bits, either sign.
inline mpz_class random_integer(std::mt19937_64& random, unsigned long bits) {
  mpz_class r = 0;
  for (unsigned long have = 0; have < bits; have += 32) r = (r << 32) + static_cast<unsigned long>(random() >> 32);
  r >>= (32 - bits % 32) % 32;
  return random() & 1 ? r : mpz_class(-r);
}

inline Vector random_vector(std::mt19937_64& random, unsigned long bits) {
  return {random_integer(random, bits), random_integer(random, bits), random_integer(random, bits)};
}

/// As random_vector, but never zero.
inline Vector random_direction(std::mt19937_64& random, unsigned long bits) {
  for (;;) {
    Vector v = random_vector(random, bits);
    if (!is_zero(v)) return v;
  }
}

enum class Size { small, word, long_, mixed };
inline constexpr Size all_sizes[] = {Size::small, Size::word, Size::long_, Size::mixed};

inline std::string name(Size size) {
  switch (size) {
    case Size::small: return "components from -3 to 3";
    case Size::word: return "60 bits";
    case Size::long_: return "2000 bits";
    case Size::mixed: return "1 to 1500 bits";
  }
  return {};
}

inline rc::Gen<mpz_class> integers(Size size) {
  const auto seeds = rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 40);
  const auto of_bits = [](std::uint64_t seed, unsigned long bits) {
    std::mt19937_64 random(seed);
    return random_integer(random, bits);
  };
  if (size == Size::small) return rc::gen::map(rc::gen::inRange(-3, 4), [](int i) { return mpz_class(i); });
  if (size == Size::mixed) return rc::gen::apply(of_bits, seeds, rc::gen::inRange(1UL, 1500UL));
  return rc::gen::map(seeds,
                      [of_bits, size](std::uint64_t seed) { return of_bits(seed, size == Size::word ? 60 : 2000); });
}

inline rc::Gen<Vector> vectors(Size size) {
  const auto three = [](const mpz_class& x, const mpz_class& y, const mpz_class& z) { return Vector{x, y, z}; };
  return rc::gen::apply(three, integers(size), integers(size), integers(size));
}

inline rc::Gen<Vector> directions(Size size) {
  return rc::gen::suchThat(vectors(size), [](const Vector& v) { return !is_zero(v); });
}

/// The property holds for vectors of each size.
template <class Property>
void for_all_sizes(const std::string& law, const Property& property) {
  for (const Size size : all_sizes)
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] { property(size); })) << law + ", " + name(size);
}

/// Zero, or one unit along an axis: what separates an exact zero from its neighbours.
inline rc::Gen<Vector> smallest_steps() {
  return rc::gen::element(Vector{0, 0, 0}, Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}, Vector{-1, 0, 0},
                          Vector{0, -1, 0}, Vector{0, 0, -1});
}

}  // namespace fathom::testing
