// SPDX-License-Identifier: GPL-3.0-or-later
// The algebra of vectors by its laws.

#include "kernels/predicates/direction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "kernels/filters/plane.hpp"
#include "kernels/filters/support.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "tests/support/line_scenes.hpp"
#include "tests/support/property.hpp"
#include "tests/support/rounding_modes.hpp"
#include "tests/support/signs.hpp"
#include "tests/support/vectors.hpp"

namespace fathom::kernels {
namespace {

using namespace fathom::testing;

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

// Enclosures against exact rationals: they hold the value, and are as narrow as stated.

using namespace fathom::testing;

constexpr double inf = std::numeric_limits<double>::infinity();

std::size_t size_in_bits(const mpz_class& c) { return c == 0 ? 0 : mpz_sizeinbase(c.get_mpz_t(), 2); }

std::size_t significant_bits(const mpz_class& c) { return c == 0 ? 0 : size_in_bits(c) - mpz_scan1(c.get_mpz_t(), 0); }

/// c * 2^-shift.
mpq_class scaled(const mpz_class& c, std::size_t shift) {
  mpq_class r(c, power_of_two(shift));
  r.canonicalize();
  return r;
}

bool encloses(const DoubleInterval& e, const mpq_class& value) {
  return mpq_class(e.low) <= value && value <= mpq_class(e.high);
}

/// How many numbers lie in the enclosure: 4 stands for more than 3.
int width(const DoubleInterval& e) {
  int n = 1;
  for (double x = e.low; x != e.high && n < 4; x = std::nextafter(x, inf)) ++n;
  return n;
}

/// Checks all that enclose() promises, component by component.
void expect_enclosed(const Vector& v) {
  const Vec3<DoubleInterval> e = enclose(v);
  const std::size_t shift = std::max({size_in_bits(v.x), size_in_bits(v.y), size_in_bits(v.z)});
  double largest = 0;
  for (const auto& [c, x] : {std::pair(v.x, e.x), std::pair(v.y, e.y), std::pair(v.z, e.z)}) {
    const mpq_class value = scaled(c, shift);
    ASSERT_TRUE(encloses(x, value)) << v << ": " << x.low << " to " << x.high;
    const bool normal = abs(value) >= mpq_class(std::numeric_limits<double>::min());
    const bool exact = c == 0 || (normal && significant_bits(c) <= 53);
    ASSERT_EQ(width(x), exact ? 1 : normal ? 2 : 3) << v << ": " << x.low << " to " << x.high;
    largest = std::max(largest, std::max(std::abs(x.low), std::abs(x.high)));
  }
  EXPECT_GE(largest, 0.5) << v;
  EXPECT_LE(largest, 1) << v;
}

TEST(Enclose, HoldsTheVectorTimesOnePowerOfTwo) {
  for (const Size size : all_sizes)
    EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [&] { expect_enclosed(*directions(size)); })) << name(size);
}

TEST(Enclose, IsSymmetricAboutZero) {
  EXPECT_TRUE(holds({.seed = 11, .runs = 400}, [] {
    const Vector v = *directions(Size::mixed);
    const Vec3<DoubleInterval> e = enclose(v), m = enclose(-v);
    RC_ASSERT(e.x.low == -m.x.high && e.x.high == -m.x.low && e.z.low == -m.z.high);
  }));
}

TEST(Enclose, IsAPointUpToFiftyThreeBits) {
  const mpz_class full = power_of_two(53) - 1;
  for (const mpz_class& c : {mpz_class(1), mpz_class(-3), full, mpz_class(full << 900), mpz_class(-full << 13)}) {
    const Vector v{c, 0, 1};
    EXPECT_EQ(width(enclose(v).x), 1) << c;
    expect_enclosed(v);
  }
  for (const mpz_class& c : {mpz_class(full + 2), mpz_class((full << 1) + 1), mpz_class(power_of_two(900) + 1)}) {
    EXPECT_EQ(width(enclose(Vector{c, 0, 1}).x), 2) << c;
    expect_enclosed(Vector{c, 0, 1});
    expect_enclosed(Vector{mpz_class(-c), 0, 1});
  }
  EXPECT_EQ(enclose(Vector{full, 0, 0}).x.low, 1 - 0x1p-53);
  EXPECT_EQ(enclose(Vector{-power_of_two(70), 0, 0}).x.high, -0.5);
}

// Components at every distance around the end of the normal and of the subnormal range, with
// mantissas that round in every way.
TEST(Enclose, HoldsWhatFallsBelowTheNormalRange) {
  const mpz_class mantissas[] = {1,
                                 3,
                                 power_of_two(52) + 1,
                                 power_of_two(53) - 1,
                                 power_of_two(54) - 1,
                                 power_of_two(80) - 1,
                                 power_of_two(80) + 1,
                                 (power_of_two(52) - 1) << 20};
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    for (const mpz_class& m : mantissas) {
      for (unsigned long top = 1000; top < 1160; ++top) expect_enclosed(Vector{power_of_two(top), m, mpz_class(-m)});
    }
    expect_enclosed(Vector{power_of_two(5000), 1, -7});
  }
  std::fesetround(FE_TONEAREST);
}

// 2^53 - 1 scaled to just below the least normal number, to which ldexp rounds it up.
TEST(Enclose, DoesNotTakeARoundedNumberForAnExactOne) {
  const DoubleInterval e = enclose(Vector{power_of_two(1074), power_of_two(53) - 1, 0}).y;
  EXPECT_LT(e.low, std::numeric_limits<double>::min());
  expect_enclosed(Vector{power_of_two(1074), power_of_two(53) - 1, 0});
}

TEST(Direction, KeepsTheExactVector) {
  const Vector v{power_of_two(300) + 1, -1, 0};
  const Direction d(v);
  EXPECT_EQ(d.exact(), v);
  EXPECT_EQ(d.enclosure().x.low, 0.5);
  EXPECT_EQ(d.enclosure().x.high, std::nextafter(0.5, 1));
  EXPECT_EQ(d.enclosure().z.low, 0);
}

// A sign that is sure is right, in every rounding mode; and in general position it is sure.

struct SignTally {
  int sure = 0, unsure = 0;
};

void expect_right(SignTally& tally, int exact, const std::function<std::optional<Sign>()>& approximate) {
  for (const int mode : rounding_modes) {
    const std::optional<Sign> sign = [&] {
      const RoundingMode set(mode);
      return approximate();
    }();
    EXPECT_TRUE(!sign || to_int(*sign) == exact) << to_int(*sign) << " for " << exact;
    ++(sign ? tally.sure : tally.unsure);
  }
}

Vector add(const Vector& v, const Vector& step) { return v + step; }

// |image - value * 2^-exponent| < 2^-53, exactly.
bool within_half_an_ulp(double image, const mpz_class& value, long exponent) {
  const mpq_class scaled = mpq_class(value) / (mpz_class(1) << static_cast<mp_bitcnt_t>(exponent));
  return abs(mpq_class(mpq_class(image) - scaled)) < mpq_class(1, mpz_class(1) << 53);
}

TEST(Images, AreTruncatedAndOdd) {
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    const auto bits = static_cast<unsigned long>(below(random, 1200) + 1);
    const Vector v = random_direction(random, bits);
    const Vec3<double> d = direction_image(v), minus = direction_image(-v);
    EXPECT_TRUE(largest(d) >= 0.5 && largest(d) <= 1);
    EXPECT_TRUE(minus.x == -d.x && minus.y == -d.y && minus.z == -d.z);
    const auto exponent = static_cast<long>(testing::bits(v));
    EXPECT_TRUE(within_half_an_ulp(d.x, v.x, exponent) && within_half_an_ulp(d.y, v.y, exponent) &&
                within_half_an_ulp(d.z, v.z, exponent));
  }
  EXPECT_EQ(image(mpz_class(1), 499), std::ldexp(1.0, -499));
  EXPECT_EQ(image(mpz_class(1), 600), 0) << "no product of two underflows";
  const mpz_class long_one = (mpz_class(1) << 60) - 1;
  EXPECT_LT(image(long_one, 60), 1) << "truncated, not rounded";
  EXPECT_GT(image(mpz_class(-long_one), 60), -1);
}

// Normal to d except for a multiple of some power of two: values on both sides of the error bound.
TEST(Images, SureSidesAreRight) {
  std::mt19937_64 random(3);
  SignTally near, far;
  for (int i = 0; i < 4000; ++i) {
    const unsigned long bits = 20 + random() % 200;
    const Vector d = random_direction(random, bits), e = random_direction(random, bits);
    const Vector n = add(cross(d, e), random_vector(random, 1 + random() % (2 * bits)));
    if (is_zero(n)) continue;
    const Direction of_n(n), of_d(d), of_e(e);
    expect_right(near, sgn(dot(n, d)), [&] { return sure_side_of_arc(image(of_n), image(of_d)); });
    expect_right(near, -sgn(dot(n, d)), [&] { return sure_side_of_arc(image(of_n), -image(of_d)); });
    expect_right(far, sgn(dot(e, d)), [&] { return sure_side_of_arc(image(of_e), image(of_d)); });
  }
  EXPECT_GT(near.sure, 1000);
  EXPECT_GT(near.unsure, 1000);
  EXPECT_LT(1000 * far.unsure, far.sure);
}

// d2 differs little from d1, or its circle nearly passes d1's point on the vertical.
TEST(Images, SureOrdersOnAVerticalAreRight) {
  std::mt19937_64 random(4);
  SignTally near, far;
  for (int i = 0; i < 4000; ++i) {
    const unsigned long bits = 20 + random() % 100;
    const Vector d1 = random_direction(random, bits), n = random_direction(random, bits),
                 v = random_direction(random, bits);
    const Vector step = random_vector(random, 1 + random() % (3 * bits)), e = random_direction(random, bits);
    const Vector c = mpz_class(dot(d1, v)) * n - mpz_class(dot(d1, n)) * v;
    const Vector close = random() & 1 ? add(mpz_class(power_of_two(2 * bits)) * d1, step) : add(cross(c, e), step);
    if (is_zero(close)) continue;
    const auto check = [&](SignTally& tally, const Vector& d2) {
      const int exact = unperturbed().order_on_vertical(Direction(d1), Direction(d2), Direction(n), Direction(v));
      EXPECT_EQ(exact, sgn(dot(c, d2)));
      expect_right(tally, exact, [&] {
        return VerticalProbe(image(Direction(d1)), image(Direction(n)), image(Direction(v))).sign(image(Direction(d2)));
      });
    };
    check(near, close);
    check(far, e);
  }
  EXPECT_GT(near.sure, 1000);
  EXPECT_GT(near.unsure, 1000);
  EXPECT_LT(1000 * far.unsure, far.sure);
}

// Every answer against the determinant of the definition, on points of mixed scales that often are
// nearly or exactly coplanar.

using Points = std::vector<Vector>;

/// A small number, times a power of two up to 2^1500, and now and then one off.
mpz_class coordinate_of_any_size() {
  const mpz_class scaled = mpz_class(*rc::gen::inRange(-4, 5))
                           << *rc::gen::weightedElement<int>({{3, 0}, {3, 53}, {2, 60}, {1, 400}, {1, 1500}});
  return scaled + *rc::gen::weightedElement<int>({{6, 0}, {1, 1}, {1, -1}});
}

Vector any_vector() { return {coordinate_of_any_size(), coordinate_of_any_size(), coordinate_of_any_size()}; }

/// Five points; half of the time the last two are combinations of the first three, perhaps one unit
/// off.
Points five_points() {
  Points p{any_vector(), any_vector(), any_vector(), any_vector(), any_vector()};
  if (*rc::gen::arbitrary<bool>()) {
    p[3] = p[0] + p[1] - p[2];
    p[4] = p[2] + p[2] - p[1];
    p[4].z += *rc::gen::inRange(-1, 2);
  }
  return p;
}

TEST(Plane, EveryAnswerIsTheSignOfTheDeterminant) {
  int on_plane = 0, off_plane = 0;
  EXPECT_TRUE(holds({.seed = 35, .runs = 3000}, [&] {
    const Points p = five_points();
    const BoxedPoints boxed(p);
    const Plane plane(boxed, 0, 1, 2);
    const Vector n = cross(p[1] - p[0], p[2] - p[0]);
    RC_ASSERT(plane.degenerate() == is_zero(n));
    for (const std::uint32_t s : {3u, 4u, 1u}) {
      RC_ASSERT(to_int(plane.side(s)) == sgn(det(Vector(p[1] - p[0]), Vector(p[2] - p[0]), Vector(p[s] - p[0]))));
      ++(plane.side(s) == Sign::zero ? on_plane : off_plane);
    }
    RC_ASSERT(to_int(plane.rise(3, 4)) == sgn(dot(n, p[4] - p[3])));
    RC_ASSERT(plane.rise(4, 3) == -plane.rise(3, 4));
    RC_ASSERT(plane.normal() == n);
  }));
  EXPECT_GT(on_plane, 1000);
  EXPECT_GT(off_plane, 1000);
}

TEST(Plane, TurnIsTheNormalsComponentAlongTheAxis) {
  int straight = 0;
  EXPECT_TRUE(holds({.seed = 35, .runs = 3000}, [&] {
    const Points p = five_points();
    const BoxedPoints boxed(p);
    for (int axis = 0; axis < 3; ++axis) {
      RC_ASSERT(to_int(turn(boxed, axis, 2, 3, 4)) == sgn(coordinate(cross(p[3] - p[2], p[4] - p[2]), axis)));
      straight += turn(boxed, axis, 2, 3, 4) == Sign::zero;
    }
  }));
  EXPECT_GT(straight, 100);
}

TEST(Plane, OneUnitIn2To1500) {
  const mpz_class far = mpz_class(1) << 1500;
  const Points p{{far, 0, 0}, {0, far, 0}, {0, 0, far}, {far - 2, 1, 1}, {far - 2, 1, 2}, {far - 2, 1, 0}};
  const BoxedPoints boxed(p);
  const Plane plane(boxed, 0, 1, 2);
  EXPECT_EQ(plane.side(3), Sign::zero);
  EXPECT_EQ(plane.side(4), Sign::positive);
  EXPECT_EQ(plane.side(5), Sign::negative);
}

// What the rounded plane says for certain, against exact arithmetic, in every rounding mode; and
// that it says so often enough.

using testing::random_integer;
using testing::random_vector;
using testing::rounding_modes;
using testing::RoundingMode;
using Random = std::mt19937_64;

/// Four points of some number of bits; the last often nearly or exactly in the plane of the others,
/// which are often close together.
std::array<Vector, 4> four_points(Random& random, unsigned long bits) {
  std::array<Vector, 4> p{random_vector(random, bits), random_vector(random, bits), random_vector(random, bits),
                          random_vector(random, bits)};
  if (random() % 3 == 0) {
    const unsigned long fine = 1 + random() % bits;
    for (std::size_t i = 1; i < 4; ++i) p[i] = p[0] + random_vector(random, fine);
  }
  if (random() % 4 == 0) {  // so near to p[0] that the images almost agree
    p[3] = p[0] + random_vector(random, bits > 55 ? bits - 55 + random() % 8 : 1);
  } else if (random() % 2 == 0) {
    p[3] = p[0] + p[1] - p[2];
    if (random() % 2 == 0) p[3].z += random_integer(random, 1 + random() % bits);
  }
  return p;
}

TEST(RoundedPlane, SaysNoSideThatIsWrong) {
  Random random(7);
  std::size_t sure = 0, zero = 0, generic_unsure = 0;
  for (int i = 0; i < 40000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const unsigned long bits = i % 3 == 0 ? 5 : i % 3 == 1 ? 60 : 700;
    const std::array<Vector, 4> p = four_points(random, bits);
    const auto at = [&](int k) { return image(p[k], static_cast<long>(bits)); };
    const std::optional<Sign> said = RoundedPlane(at(0), at(1), at(2)).side(at(3));
    const int exact = sgn(det(Vector(p[1] - p[0]), Vector(p[2] - p[0]), Vector(p[3] - p[0])));
    if (said) {
      ASSERT_EQ(to_int(*said), exact) << i;
      ++sure;
    }
    if (exact == 0) ++zero;
    const std::array<Vector, 4> g{random_vector(random, bits), random_vector(random, bits), random_vector(random, bits),
                                  random_vector(random, bits)};
    const auto plain = [&](int k) { return image(g[k], static_cast<long>(bits)); };
    if (bits == 60 && RoundedPlane(plain(0), plain(1), plain(2)).side(plain(3)) == std::nullopt) ++generic_unsure;
  }
  EXPECT_GT(sure, 15000U);
  EXPECT_GT(zero, 5000U);
  EXPECT_LT(generic_unsure, 10U) << "of 13333";
}

TEST(RoundedPlane, SurelyBeyondIsNeverWrongAndRarelyMissed) {
  Random random(8);
  std::size_t beyond = 0, missed = 0;
  for (int i = 0; i < 20000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const unsigned long bits = i % 2 == 0 ? 60 : 700;
    const std::array<Vector, 4> p = four_points(random, bits);
    const Vector n = cross(Vector(p[1] - p[0]), Vector(p[2] - p[0]));
    const mpz_class height = dot(n, p[0]), square = dot(n, n);
    if (square == 0 || height == 0) continue;
    const auto at = [&](int k) { return image(p[k], static_cast<long>(bits)); };
    const RoundedPlane plane(at(0), at(1), at(2));
    // The radius of the plane itself: it is not beyond that. A little less: it is, if O is below.
    const double radius = root_from_above(height * height, square, static_cast<long>(bits));
    ASSERT_FALSE(plane.surely_beyond(radius)) << i;
    if (height < 0) {
      ASSERT_FALSE(plane.surely_beyond(0)) << i;
      continue;
    }
    const bool said = plane.surely_beyond(radius * 0.99);
    if (plane.trustworthy()) ++(said ? beyond : missed);
  }
  EXPECT_GT(beyond, 5000U);
  EXPECT_LT(missed, beyond / 10);
}

TEST(RoundedPlane, ImagesAreNear) {
  Random random(9);
  for (int i = 0; i < 5000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const unsigned long bits = 1 + random() % 900;
    const Vector v = random_vector(random, bits);
    const double x = image(v, static_cast<long>(bits)).x;
    const mpq_class difference = mpq_class(x) - mpq_class(v.x, testing::power_of_two(bits));
    ASSERT_LE(abs(difference), mpq_class(1, testing::power_of_two(52)));
  }
}

TEST(RootFromAbove, IsAboveAndNear) {
  Random random(10);
  for (int i = 0; i < 5000; ++i) {
    const RoundingMode mode(rounding_modes[i % 4]);
    const mpz_class numerator = abs(random_integer(random, 1 + random() % 400)),
                    denominator = abs(random_integer(random, 1 + random() % 400)) + 1;
    const double root = root_from_above(numerator, denominator, 0);
    ASSERT_TRUE(std::isfinite(root));
    const mpq_class square = mpq_class(root) * mpq_class(root);
    mpq_class truth(numerator, denominator);
    truth.canonicalize();
    ASSERT_GE(square, truth);
    ASSERT_LE(square, truth * mpq_class(1001, 1000));
  }
  EXPECT_EQ(root_from_above(0, 1, 5), 0);
  EXPECT_GE(root_from_above(testing::power_of_two(4000), 1, 0), 1e300) << "too large for binary64: infinite";
  EXPECT_GT(root_from_above(1, testing::power_of_two(6000), 0), 0) << "too small: not zero";
}

TEST(LikelyExtremePoint, IsExtremeWhereNothingTies) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vector> points(1 + random() % 700);
    for (Vector& p : points) p = random_vector(random, 40);
    const PointCloud cloud(points, binary_exponent(points));
    const Vector u = testing::random_direction(random, 20);
    const std::uint32_t found = likely_extreme_point(cloud.images(), image(u, 20));
    EXPECT_EQ(found, extreme_points_naive(points, u).front());
  }
  EXPECT_EQ(likely_extreme_point(PointCloud({{1, 2, 3}, {4, 5, 6}}).images(), {0, 0, 0}), 0U);
}

}  // namespace
}  // namespace fathom::kernels
