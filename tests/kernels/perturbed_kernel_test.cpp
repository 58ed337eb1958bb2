// SPDX-License-Identifier: GPL-3.0-or-later
// The numbered axioms of the predicates; each sign against the plain integer formula and against
// the geometry that it stands for; and which tier decided.
#include "kernels/predicates/perturbed_kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <functional>
#include <string>
#include <utility>

#include "kernels/context.hpp"
#include "tests/support/plain_predicates.hpp"
#include "tests/support/property.hpp"
#include "tests/support/signs.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

// Plain formulas, written out once more.
int plain_dot(const Vector& a, const Vector& b) { return sgn(mpz_class(a.x * b.x + a.y * b.y + a.z * b.z)); }

int plain_det(const Vector& a, const Vector& b, const Vector& c) {
  const mpz_class plus = a.x * b.y * c.z + a.y * b.z * c.x + a.z * b.x * c.y;
  const mpz_class minus = a.z * b.y * c.x + a.y * b.x * c.z + a.x * b.z * c.y;
  return sgn(mpz_class(plus - minus));
}

mpq_class quotient(const mpz_class& p, const mpz_class& q) {
  mpq_class r(p, q);
  r.canonicalize();
  return r;
}

/// Unlike GMP's cmp, never beyond -1 and 1.
int order(const mpq_class& p, const mpq_class& q) { return sgn(mpq_class(p - q)); }

PredicateCounts counts;  // of all calls below

int equator(const Vector& n, const Vector& z) {
  return unperturbed(counts).side_of_equator(Direction(n), Direction(z));
}
int xorder(const Vector& n1, const Vector& n2, const Vector& v) {
  return unperturbed(counts).x_order(Direction(n1), Direction(n2), Direction(v));
}
int side(const Vector& n, const Vector& d) { return unperturbed(counts).side_of_arc(Direction(n), Direction(d)); }
int vertical_order(const Vector& d1, const Vector& d2, const Vector& n, const Vector& v) {
  return unperturbed(counts).order_on_vertical(Direction(d1), Direction(d2), Direction(n), Direction(v));
}
int order_far_out(const Vector& d1, const Vector& d2, const Vector& z) {
  return unperturbed(counts).order_at_infinity(Direction(d1), Direction(d2), Direction(z));
}

/// A direction orthogonal to u up to one unit in one component.
Vector nearly_orthogonal(const Vector& u, Size size) {
  const Vector r = cross(u, *directions(size)) + *smallest_steps();
  RC_PRE(!is_zero(r));
  return r;
}

/// A combination of two directions, up to one unit in one component.
Vector nearly_dependent(const Vector& a, const Vector& b, Size size) {
  const Vector r = *integers(size) * a + *integers(size) * b + *smallest_steps();
  RC_PRE(!is_zero(r));
  return r;
}

/// A frame (v, z) with <v,z> = 0.
std::pair<Vector, Vector> frame(Size size) {
  const Vector v = *directions(size);
  const Vector z = cross(v, *directions(size));
  RC_PRE(!is_zero(z));
  return {v, z};
}

/// A direction in the open hemisphere of z.
Vector in_hemisphere(const Vector& z, Size size) {
  const Vector n = *directions(size);
  const int s = plain_dot(n, z);
  RC_PRE(s != 0);
  return s > 0 ? n : -n;
}

TEST(SideOfEquator, IsTheSignOfTheProduct) {
  for_all_sizes("plain", [](Size size) {
    const Vector z = *directions(size), n = *directions(size), m = nearly_orthogonal(z, size);
    RC_ASSERT(equator(n, z) == plain_dot(n, z));
    RC_ASSERT(equator(m, z) == plain_dot(m, z));
    RC_ASSERT(equator(-m, z) == -equator(m, z));  // (1)
    RC_ASSERT(equator(m, -z) == -equator(m, z));
  });
}

TEST(XOrder, IsTheSignOfTheDeterminant) {
  for_all_sizes("plain", [](Size size) {
    const Vector v = *directions(size), n1 = *directions(size), n2 = *directions(size),
                 n3 = nearly_dependent(n1, v, size);
    RC_ASSERT(xorder(n1, n2, v) == plain_det(n1, n2, v));
    RC_ASSERT(xorder(n1, n3, v) == plain_det(n1, n3, v));
    RC_ASSERT(xorder(n3, n1, v) == -xorder(n1, n3, v));  // (1)
    RC_ASSERT(xorder(n1, n1, v) == 0);
  });
}

TEST(XOrder, OrdersTheAbscissae) {
  for_all_sizes("det(n1,n2,v) |z|^2 = (x2 - x1) <n1,z><n2,z>", [](Size size) {
    const auto [v, z] = frame(size);
    const Vector n1 = in_hemisphere(z, size),
                 n2 = *rc::gen::element(in_hemisphere(z, size), nearly_dependent(n1, v, size));
    RC_PRE(plain_dot(n2, z) > 0);
    const Vector right = cross(v, z);
    const mpq_class x1 = quotient(dot(n1, right), dot(n1, z)), x2 = quotient(dot(n2, right), dot(n2, z));
    RC_ASSERT(mpq_class(plain::XOrder{}(n1, n2, v) * dot(z, z)) == mpq_class((x2 - x1) * dot(n1, z) * dot(n2, z)));
    RC_ASSERT(xorder(n1, n2, v) == order(x2, x1));  // (3) among others
  });
}

TEST(XOrder, IsTransitiveInOneHemisphere) {
  for_all_sizes("transitive", [](Size size) {
    const auto [v, z] = frame(size);
    const Vector a = in_hemisphere(z, size), b = in_hemisphere(z, size), c = in_hemisphere(z, size);
    const int ab = xorder(a, b, v), bc = xorder(b, c, v), ac = xorder(a, c, v);
    if (ab >= 0 && bc >= 0) RC_ASSERT(ac == std::max(ab, bc));  // (2)
    if (ab <= 0 && bc <= 0) RC_ASSERT(ac == std::min(ab, bc));
  });
}

TEST(SideOfArc, IsTheSignOfTheProduct) {
  for_all_sizes("plain", [](Size size) {
    const Vector d = *directions(size), n = *directions(size), m = nearly_orthogonal(d, size), on = cross(d, n);
    RC_ASSERT(side(n, d) == plain_dot(n, d));
    RC_ASSERT(side(m, d) == plain_dot(m, d));
    RC_ASSERT(side(-m, d) == -side(m, d));  // (1)
    RC_ASSERT(side(m, -d) == -side(m, d));
    if (!is_zero(on)) RC_ASSERT(side(on, d) == 0);  // (2)
  });
}

TEST(SideOfArc, IsAboveTheArcWhereTheCirclePointsUp) {
  for_all_sizes("the arc's point over n is n + t v", [](Size size) {
    const auto [v, z] = frame(size);
    const Vector n = in_hemisphere(z, size);
    Vector d = *rc::gen::element(*directions(size), nearly_orthogonal(n, size));
    RC_PRE(plain_dot(d, v) != 0);
    if (plain_dot(d, v) < 0) d = -d;
    const mpq_class t = quotient(-dot(d, n), dot(d, v));
    RC_ASSERT(side(n, d) == -sgn(t));
  });
}

TEST(OrderOnVertical, IsTheSignOfTheBinetCauchyForm) {
  for_all_sizes("det(d1, d2, v x n), antisymmetric, odd", [](Size size) {
    const Vector v = *directions(size), n = *directions(size), d1 = *directions(size);
    const Vector d2 = *rc::gen::element(*directions(size), nearly_dependent(d1, cross(v, n), size));
    const int s = vertical_order(d1, d2, n, v);
    RC_ASSERT(s == plain_det(d1, d2, cross(v, n)));
    RC_ASSERT(vertical_order(d2, d1, n, v) == -s);   // (1)
    RC_ASSERT(vertical_order(-d1, d2, n, v) == -s);  // (2)
    RC_ASSERT(vertical_order(d1, -d2, n, v) == -s);
    RC_ASSERT(vertical_order(d1, d1, n, v) == 0);
  });
}

TEST(OrderOnVertical, ComparesTheHeightsOfTheArcs) {
  for_all_sizes("t = -<d,n>/<d,v>", [](Size size) {
    const auto [v, z] = frame(size);
    const Vector n = in_hemisphere(z, size), d1 = *directions(size);
    const Vector d2 = *rc::gen::element(*directions(size), nearly_dependent(d1, cross(v, n), size));
    const int up1 = plain_dot(d1, v), up2 = plain_dot(d2, v);
    RC_PRE(up1 != 0 && up2 != 0);
    const mpq_class t1 = quotient(-dot(d1, n), dot(d1, v)), t2 = quotient(-dot(d2, n), dot(d2, v));
    // In the chart n + t v lies at the height (<n,v> + t |v|^2) / <n,z>.
    const mpq_class y1 = (dot(n, v) + t1 * dot(v, v)) / dot(n, z), y2 = (dot(n, v) + t2 * dot(v, v)) / dot(n, z);
    RC_ASSERT(vertical_order(d1, d2, n, v) == up1 * up2 * order(y1, y2));
  });
}

TEST(OrderAtInfinity, IsTheSignOfTheDeterminant) {
  for_all_sizes("plain, antisymmetric, odd", [](Size size) {
    const Vector z = *directions(size), d1 = *directions(size);
    const Vector d2 = *rc::gen::element(*directions(size), nearly_dependent(d1, z, size));
    const int s = order_far_out(d1, d2, z);
    RC_ASSERT(s == plain_det(d1, d2, z));
    RC_ASSERT(order_far_out(d2, d1, z) == -s);   // (1)
    RC_ASSERT(order_far_out(-d1, d2, z) == -s);  // (2)
    RC_ASSERT(order_far_out(d1, -d2, z) == -s);
    RC_ASSERT(order_far_out(d1, d2, -z) == -s);
  });
}

TEST(OrderAtInfinity, IsTheOrderOnVerticalsFarAway) {
  for_all_sizes("n = -(v x z), divided by |v|^2", [](Size size) {
    const auto [v, z] = frame(size);
    const Vector d1 = *directions(size), d2 = *directions(size), left = -cross(v, z);
    const mpz_class far = plain::OrderOnVertical{}(d1, d2, left, v);
    RC_ASSERT(far == mpz_class(plain::OrderAtInfinity{}(d1, d2, z) * dot(v, v)));
    // The form is linear in n: the verticals through z + k left, x = -k |v x z|^2 / |z|^2, have one
    // sign from some k on.
    const mpz_class middle = plain::OrderOnVertical{}(d1, d2, z, v), k = abs(middle) + 1;
    RC_PRE(far != 0);
    RC_ASSERT(vertical_order(d1, d2, z + k * left, v) == order_far_out(d1, d2, z));
    RC_ASSERT(vertical_order(d1, d2, z - k * left, v) == -order_far_out(d1, d2, z));
  });
}

TEST(Predicates, DoNotSeeTheLengthOfADirection) {
  for_all_sizes("scaled", [](Size size) {
    const Vector a = *directions(size), b = *directions(size), c = *directions(size), d = nearly_dependent(a, b, size);
    const mpz_class s = abs(*integers(Size::mixed)) + 1, t = power_of_two(*rc::gen::inRange(0UL, 3000UL));
    RC_ASSERT(equator(s * a, t * b) == equator(a, b));
    RC_ASSERT(xorder(s * a, t * b, s * d) == xorder(a, b, d));
    RC_ASSERT(side(t * d, s * c) == side(d, c));
    RC_ASSERT(vertical_order(a, s * b, t * c, s * d) == vertical_order(a, b, c, d));
    RC_ASSERT(order_far_out(t * a, s * b, s * d) == order_far_out(a, b, d));
  });
}

// The enclosure of 2^53 - 1 beside 2^1074 must not be the number to which it rounds: the product
// would vanish.
TEST(Predicates, AreRightBelowTheNormalRange) {
  const Vector n{power_of_two(1074), power_of_two(53) - 1, 0}, z{-power_of_two(53), power_of_two(1074), 0};
  EXPECT_EQ(equator(n, z), -1);
  EXPECT_EQ(side(n, -z), 1);
  EXPECT_EQ(equator(Vector{power_of_two(4000), 1, 0}, Vector{0, 1, 1}), 1);
  EXPECT_EQ(equator(Vector{power_of_two(4000), 1, 0}, Vector{-1, power_of_two(4000), 0}), 0);
}

/// What `calls` add to the counters of one predicate.
struct Counted {
  std::uint64_t calls, exact, zero;
};

Counted counted(Predicate id, const std::function<void()>& calls) {
  const PredicateCounts before = counts;
  calls();
  const TierCounts made = (counts - before)[static_cast<std::size_t>(id)];
  return {made.calls, made.exact, made.zero};
}

void expect_counts(const Counted& c, std::uint64_t calls, std::uint64_t exact, std::uint64_t zero) {
  EXPECT_EQ(c.calls, calls);
  EXPECT_EQ(c.exact, exact);
  EXPECT_EQ(c.zero, zero);
}

// In small integers the intervals are points, so even an exact zero is seen by the first tier.
TEST(Tiers, IntervalsDecideSmallIntegers) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Vector a = *directions(Size::small), b = *directions(Size::small), c = *directions(Size::small),
                 d = *directions(Size::small);
    const auto check = [](Predicate id, const std::function<int()>& call) {
      int sign = 0;
      const Counted c = counted(id, [&] { sign = call(); });
      RC_ASSERT(c.calls == 1U);
      RC_ASSERT(c.exact == 0U);
      RC_ASSERT(c.zero == (sign == 0 ? 1U : 0U));
    };
    check(Predicate::side_of_equator, [&] { return equator(a, b); });
    check(Predicate::x_order, [&] { return xorder(a, b, c); });
    check(Predicate::side_of_arc, [&] { return side(a, b); });
    check(Predicate::order_on_vertical, [&] { return vertical_order(a, b, c, d); });
    check(Predicate::order_at_infinity, [&] { return order_far_out(a, b, c); });
  }));
}

TEST(Tiers, IntervalsDecideLargeIntegersInGeneralPosition) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    std::mt19937_64 random(*rc::gen::inRange(0, 1 << 30));
    const Vector a = random_direction(random, 2000), b = random_direction(random, 2000),
                 c = random_direction(random, 2000);
    RC_PRE(abs(plain::XOrder{}(a, b, c)) > power_of_two(5970));
    const Counted made = counted(Predicate::x_order, [&] { xorder(a, b, c); });
    RC_ASSERT(made.calls == 1U && made.exact == 0U && made.zero == 0U);
  }));
}

TEST(Tiers, ExactArithmeticDecidesNearZeros) {
  std::mt19937_64 random(5);
  for (const unsigned long bits : {60, 2000}) {
    const Vector a = random_direction(random, bits), b = random_direction(random, bits),
                 c = random_direction(random, bits);
    const Vector unit{1, 0, 0}, sum = a + b;
    ASSERT_NE(a.x, 0);
    expect_counts(counted(Predicate::side_of_equator, [&] { EXPECT_EQ(equator(cross(a, b) + unit, a), sgn(a.x)); }), 1,
                  1, 0);
    expect_counts(counted(Predicate::side_of_arc, [&] { EXPECT_EQ(side(cross(a, b) - unit, a), -sgn(a.x)); }), 1, 1, 0);
    expect_counts(counted(Predicate::x_order, [&] { EXPECT_EQ(xorder(a, b, sum + unit), plain_det(a, b, unit)); }), 1,
                  1, 0);
    expect_counts(counted(Predicate::order_at_infinity,
                          [&] { EXPECT_EQ(order_far_out(a, b, sum - unit), -plain_det(a, b, unit)); }),
                  1, 1, 0);
    expect_counts(counted(Predicate::order_on_vertical,
                          [&] { EXPECT_EQ(vertical_order(a, a + unit, b, c), plain_det(a, unit, cross(c, b))); }),
                  1, 1, 0);
  }
}

TEST(Tiers, ExactZerosAreCountedAsZero) {
  std::mt19937_64 random(6);
  const Vector a = random_direction(random, 700), b = random_direction(random, 700), c = random_direction(random, 700),
               sum = a + b;
  expect_counts(counted(Predicate::side_of_equator, [&] { EXPECT_EQ(equator(cross(a, b), a), 0); }), 1, 1, 1);
  expect_counts(counted(Predicate::side_of_arc, [&] { EXPECT_EQ(side(cross(a, b), b), 0); }), 1, 1, 1);
  expect_counts(counted(Predicate::x_order, [&] { EXPECT_EQ(xorder(a, b, sum), 0); }), 1, 1, 1);
  expect_counts(counted(Predicate::order_at_infinity, [&] { EXPECT_EQ(order_far_out(a, b, sum), 0); }), 1, 1, 1);
  expect_counts(counted(Predicate::order_on_vertical, [&] { EXPECT_EQ(vertical_order(a, mpz_class(3) * a, b, c), 0); }),
                1, 1, 1);
}

TEST(Tiers, LeaveTheRoundingModeAlone) {
  const Vector a{1, 2, 3}, b{power_of_two(200) + 1, 5, 7};
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const int signs[] = {side(a, b), side(a, cross(a, b)), xorder(a, b, a + b)};
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(after, mode);
    EXPECT_EQ(signs[0], 1);
    EXPECT_EQ(signs[1], 0);
    EXPECT_EQ(signs[2], 0);
  }
}

}  // namespace
}  // namespace fathom::kernels
