// SPDX-License-Identifier: GPL-3.0-or-later
// The algebra of vectors by its laws.
#include "kernels/vector.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "kernels/number/rational.hpp"
#include "tests/support/property.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

template <class Property>
void for_all_sizes(const std::string& law, const Property& property) {
  for (const Size size : all_sizes)
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] { property(size); })) << law + ", " + name(size);
}

TEST(Vector, ProductsOfTheAxes) {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(cross(x, y), z);
  EXPECT_EQ(cross(y, z), x);
  EXPECT_EQ(cross(z, x), y);
  EXPECT_EQ(det(x, y, z), 1);
  EXPECT_EQ(dot(x, x), 1);
  EXPECT_EQ(dot(x, y), 0);
}

TEST(Vector, ProductsAreBilinearAndAlternating) {
  for_all_sizes("products", [](Size size) {
    const Vector a = *vectors(size), b = *vectors(size), c = *vectors(size);
    RC_ASSERT(dot(a, b) == dot(b, a));
    RC_ASSERT(dot(a + b, c) == mpz_class(dot(a, c) + dot(b, c)));
    RC_ASSERT(cross(a, b) == -cross(b, a));
    RC_ASSERT(cross(a + b, c) == cross(a, c) + cross(b, c));
    RC_ASSERT(dot(cross(a, b), a) == 0);
    RC_ASSERT(det(a, b, c) == det(b, c, a));
    RC_ASSERT(det(a, b, c) == mpz_class(-det(b, a, c)));
    // Lagrange: |a x b|^2 + <a,b>^2 = |a|^2 |b|^2.
    RC_ASSERT(mpz_class(dot(cross(a, b), cross(a, b)) + dot(a, b) * dot(a, b)) == mpz_class(dot(a, a) * dot(b, b)));
  });
}

TEST(Vector, SumsHaveInverses) {
  for_all_sizes("sums", [](Size size) {
    const Vector a = *vectors(size), b = *vectors(size);
    RC_ASSERT(a + b == b + a);
    RC_ASSERT(a + b - b == a);
    RC_ASSERT(a - b == a - b);
    RC_ASSERT(is_zero(a - a));
    RC_ASSERT(is_zero(a) == (dot(a, a) == 0));
  });
}

TEST(PrimitiveAlong, IsThatOfAnyMultiple) {
  EXPECT_EQ(primitive_along({0, 0, 0}), (Vector{0, 0, 0}));
  EXPECT_EQ(primitive_along({mpq_class(1, 2), mpq_class(-1, 3), 0}), (Vector{3, -2, 0}));
  for_all_sizes("multiples", [](Size size) {
    const Vector v = *vectors(size);
    const mpz_class p = 1 + abs((*vectors(size)).x), q = 1 + abs((*vectors(size)).y);
    RC_ASSERT(primitive_along({ratio(p * v.x, q), ratio(p * v.y, q), ratio(p * v.z, q)}) == primitive(v));
  });
}

TEST(LexicographicallyLess, OrdersByTheFirstDifference) {
  for_all_sizes("as arrays", [](Size size) {
    const Vector a = *vectors(size), b = *rc::gen::element(*vectors(size), a + *smallest_steps());
    const std::array<mpz_class, 3> of_a{a.x, a.y, a.z}, of_b{b.x, b.y, b.z};
    RC_ASSERT(lexicographically_less(a, b) ==
              std::lexicographical_compare(of_a.begin(), of_a.end(), of_b.begin(), of_b.end()));
  });
}

TEST(Primitive, LeavesNoCommonDivisorAndTheDirection) {
  for_all_sizes("primitive", [](Size size) {
    const Vector v = *directions(size);
    const mpz_class s = abs(*integers(size)) + 1;
    const Vector p = primitive(s * v);
    RC_ASSERT(gcd(gcd(p.x, p.y), p.z) == 1);
    RC_ASSERT(is_zero(cross(p, v)));
    RC_ASSERT(dot(p, v) > 0);
    RC_ASSERT(primitive(p) == p);
    RC_ASSERT(primitive(v) == p);
  });
  EXPECT_EQ(primitive(Vector{0, 0, 0}), (Vector{0, 0, 0}));
  EXPECT_EQ(primitive(Vector{0, -6, 0}), (Vector{0, -1, 0}));
  EXPECT_EQ(primitive(Vector{4, -6, 10}), (Vector{2, -3, 5}));
}

TEST(SameDirection, IsEqualityOfPrimitives) {
  for_all_sizes("same direction", [](Size size) {
    const Vector a = *directions(size);
    const mpz_class s = abs(*integers(size)) + 1, t = *integers(size);
    RC_ASSERT(same_direction(s * a, a));
    RC_ASSERT(!same_direction(mpz_class(-s) * a, a));
    const Vector b = *rc::gen::element(*directions(size), t * a, s * a + *smallest_steps());
    RC_PRE(!is_zero(b));
    RC_ASSERT(same_direction(a, b) == (primitive(a) == primitive(b)));
  });
  EXPECT_FALSE(same_direction(Vector{0, 0, 1}, Vector{0, 1, 0}));
  EXPECT_FALSE(same_direction(Vector{1, 0, 0}, Vector{1, 0, 1}));
  EXPECT_TRUE(same_direction(Vector{-2, 0, 4}, Vector{-3, 0, 6}));
}

}  // namespace
}  // namespace fathom::kernels
