// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor models against exact rationals: whatever two models hold, their product and sums hold.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "kernels/filters/line_frame.hpp"
#include "tests/support/exact_floats.hpp"
#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;
using taylor::combination;
using taylor::least;
using taylor::operator*;
using error_bound::unit_of;

double any_double(Random& random) {
  return std::ldexp(static_cast<double>(random() % 2000001) - 1000000, -static_cast<int>(random() % 40));
}

template <class Number>
Number any(Random& random) {
  Number x = any_double(random);
  // Digits all the way down.
  if constexpr (std::is_same_v<Number, WideFloat>) x = x * (1 + WideFloat(any_double(random)) * 0x1p-70) + any_double(random) * 0x1p-60;
  return x;
}

template <class Number>
TaylorModel<Number> any_model(Random& random) {
  TaylorModel<Number> m;
  for (Number& c : m.c) c = random() % 5 == 0 ? Number(0) : any<Number>(random);
  m.radius = random() % 2 ? std::fabs(any_double(random)) : 0;
  // Radii as small as the numbers' own errors, or they would hide these.
  if (random() % 2) m.radius *= unit_of<Number>;
  return m;
}

template <class Number>
mpq_class polynomial(const TaylorModel<Number>& m, const mpq_class& s, const mpq_class& t) {
  const auto c = [&](std::size_t i) { return exactly(m.c[i]); };
  return c(0) + c(1) * s + c(2) * t + c(3) * s * s + c(4) * s * t + c(5) * t * t;
}

// A value at (s, t) of some function that the model holds.
template <class Number>
mpq_class held(const TaylorModel<Number>& m, const mpq_class& s, const mpq_class& t, Random& random) {
  return polynomial(m, s, t) + mpq_class(m.radius) * mpq_class(static_cast<long>(random() % 3) - 1);
}

mpq_class in_range(Random& random) {
  mpq_class x(static_cast<long>(random() % 2001) - 1000, 1000);
  x.canonicalize();
  return x;
}

template <class Number>
void expect_holds(const TaylorModel<Number>& m, const mpq_class& s, const mpq_class& t, const mpq_class& value) {
  EXPECT_LE(abs(mpq_class(value - polynomial(m, s, t))), mpq_class(m.radius));
}

template <class Number>
class TaylorModels : public ::testing::Test {};
using Numbers = ::testing::Types<double, WideFloat>;
TYPED_TEST_SUITE(TaylorModels, Numbers);

TYPED_TEST(TaylorModels, OperationsHoldWhatTheyShould) {
  using Number = TypeParam;
  Random random(3);
  for (int n = 0; n < 20000; ++n) {
    const TaylorModel<Number> f = any_model<Number>(random), g = any_model<Number>(random);
    const Number a = any<Number>(random), b = any<Number>(random);
    TaylorModel<Number> product, sum;
    Number below = 0;
    {
      const RoundingMode mode(rounding_modes[n % 4]);
      product = f * g;
      sum = combination(a, f, b, g);
      below = least(f);
    }
    const mpq_class s = n % 3 ? in_range(random) : mpq_class(n % 2 ? 1 : -1), t = n % 5 ? in_range(random) : mpq_class(1);
    const mpq_class x = held(f, s, t, random), y = held(g, s, t, random);
    expect_holds(product, s, t, x * y);
    expect_holds(sum, s, t, exactly(a) * x + exactly(b) * y);
    EXPECT_LE(exactly(below), x);
  }
}

TYPED_TEST(TaylorModels, ProductOfSidesIsTheProduct) {
  using Number = TypeParam;
  Random random(4);
  for (int n = 0; n < 20000; ++n) {
    TaylorModel<Number> f = any_model<Number>(random), g = any_model<Number>(random);
    f.c[2] = f.c[4] = f.c[5] = g.c[1] = g.c[3] = g.c[4] = 0;
    const RoundingMode mode(rounding_modes[n % 4]);
    const TaylorModel<Number> product = taylor::product_of_sides(f, g), any = f * g;
    EXPECT_TRUE(product.c == any.c && product.radius == any.radius);
  }
}

// Not just sound: where the square's minimum is known the bound attains it, up to rounding.
TYPED_TEST(TaylorModels, LeastIsAttained) {
  const auto least_of = [](std::array<TypeParam, 6> c) {
    TaylorModel<TypeParam> m;
    m.c = c;
    return truncated(least(m));
  };
  EXPECT_NEAR(least_of({7, 0, 0, 0, 0, 0}), 7, 1e-12);
  EXPECT_NEAR(least_of({0, 1, 2, 0, 0, 0}), -3, 1e-12);
  EXPECT_NEAR(least_of({0, 1, 0, 1, 0, 1}), -0.25, 1e-12);          // at s = -1/2
  EXPECT_NEAR(least_of({0, 0, 0, 1, 2, 1}), 0, 1e-12);              // (s + t)^2
  EXPECT_NEAR(least_of({0, -2, -2, 1, 2, 1}), -1, 1e-12);           // (s + t - 1)^2 - 1
  EXPECT_NEAR(least_of({0, 0, 0, 0, 1, 0}), -1, 1e-12);             // s t
  EXPECT_NEAR(least_of({0, 0, 0, -1, 0, -1}), -2, 1e-12);           // concave: at a corner
  EXPECT_NEAR(least_of({0, 5, 0, 1, 0.5, 1}), -4 - 0.0625, 1e-12);  // at s = -1, t = 1/4
}

}  // namespace
}  // namespace fathom::kernels
