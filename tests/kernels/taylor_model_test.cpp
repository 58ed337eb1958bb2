// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor models against exact rationals: whatever two models hold, their product and sums hold.
#include "kernels/filters/taylor_model.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "tests/support/line_scenes.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;
using taylor::combination;
using taylor::least;
using taylor::operator*;

double any(Random& random) { return std::ldexp(static_cast<double>(random() % 2000001) - 1000000, -static_cast<int>(random() % 40)); }

TaylorModel any_model(Random& random) {
  TaylorModel m;
  for (double& c : m.c) c = random() % 5 == 0 ? 0 : any(random);
  m.radius = random() % 2 ? std::fabs(any(random)) : 0;
  return m;
}

mpq_class polynomial(const TaylorModel& m, const mpq_class& s, const mpq_class& t) {
  const auto c = [&](std::size_t i) { return mpq_class(m.c[i]); };
  return c(0) + c(1) * s + c(2) * t + c(3) * s * s + c(4) * s * t + c(5) * t * t;
}

// A value at (s, t) of some function that the model holds.
mpq_class held(const TaylorModel& m, const mpq_class& s, const mpq_class& t, Random& random) {
  return polynomial(m, s, t) + mpq_class(m.radius) * mpq_class(static_cast<long>(random() % 3) - 1);
}

mpq_class in_range(Random& random) {
  mpq_class x(static_cast<long>(random() % 2001) - 1000, 1000);
  x.canonicalize();
  return x;
}

void expect_holds(const TaylorModel& m, const mpq_class& s, const mpq_class& t, const mpq_class& value) {
  EXPECT_LE(abs(mpq_class(value - polynomial(m, s, t))), mpq_class(m.radius));
}

TEST(TaylorModel, OperationsHoldWhatTheyShould) {
  Random random(3);
  for (int n = 0; n < 20000; ++n) {
    const TaylorModel f = any_model(random), g = any_model(random);
    const double a = any(random), b = any(random);
    TaylorModel product, sum;
    double below = 0;
    {
      const RoundingMode mode(rounding_modes[n % 4]);
      product = f * g;
      sum = combination(a, f, b, g);
      below = least(f);
    }
    const mpq_class s = n % 3 ? in_range(random) : mpq_class(n % 2 ? 1 : -1), t = n % 5 ? in_range(random) : mpq_class(1);
    const mpq_class x = held(f, s, t, random), y = held(g, s, t, random);
    expect_holds(product, s, t, x * y);
    expect_holds(sum, s, t, mpq_class(a) * x + mpq_class(b) * y);
    EXPECT_LE(mpq_class(below), x);
  }
}

// Not just sound: where the square's minimum is known the bound attains it, up to rounding.
TEST(TaylorModel, LeastIsAttained) {
  const auto least_of = [](std::array<double, 6> c) {
    TaylorModel m;
    m.c = c;
    return least(m);
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
