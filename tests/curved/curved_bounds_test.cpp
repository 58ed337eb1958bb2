// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds where the answer is known: where people put shapes on each other, in closed form, at the
// ends of numbers, and out of reach.
#include "reference/curved/curved_bounds.hpp"

#include <gtest/gtest.h>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/random_shapes.hpp"

namespace fathom::curved {
namespace {

using testing::ShapeMaker;

CurvedBounds bounds_of(const Shape& a, const Shape& b, unsigned bits = 40, std::size_t support_calls = 5000,
                       bool coaxial = true) {
  kernels::Context context;
  CurvedBounds bounds = signed_bounds(context, a, b, bits, support_calls, coaxial);
  EXPECT_LE(bounds.support_calls, support_calls);
  if (bounds.bracket.polytope.facets.size() < 300) {
    const kernels::Report report = validate(bounds, a, b);
    EXPECT_TRUE(report.ok()) << testing::text(report);
  }
  return bounds;
}

Shape at(const Shape& shape, const Point& p, const Quaternion& q = {1, 0, 0, 0}) {
  return moved(shape, rigid_pose(q, p));
}
Shape ball(const mpq_class& r) { return ShapeMaker::one_atom({{0, 0, 0}, {{r, 0, 0}, {0, r, 0}, {0, 0, r}}}); }
Shape disc(const mpq_class& r) { return ShapeMaker::one_atom({{0, 0, 0}, {{r, 0, 0}, {0, r, 0}}}); }

const Quaternion quarter_x{1, 1, 0, 0}, half_x{0, 1, 0, 0}, along_generator{3, 0, -1, 0};
const Shape unit_box = box({1, 1, 1});

struct Placed {
  const char* what;
  Shape a, b;
};

// Each in its place, and both in one pose that no machine number holds.
void expect_exactly(const Placed& placed, const mpq_class& value) {
  const Pose pose =
      rigid_pose({exact_value(0.3), exact_value(0.1), exact_value(-0.7), exact_value(0.52)}, {mpq_class(1, 3), 1, -2});
  for (const bool turned : {false, true}) {
    for (const bool swapped : {false, true}) {
      const Shape a = turned ? moved(placed.a, pose) : placed.a, b = turned ? moved(placed.b, pose) : placed.b;
      const CurvedBounds bounds = swapped ? bounds_of(b, a) : bounds_of(a, b);
      EXPECT_EQ(bounds.low, value) << placed.what << (turned ? ", turned" : "") << (swapped ? ", swapped" : "");
      EXPECT_EQ(bounds.high, value) << placed.what << (turned ? ", turned" : "") << (swapped ? ", swapped" : "");
    }
  }
}

TEST(CurvedBounds, DecideTouchingWherePeopleMeetIt) {
  const mpq_class third(1, 3), half(1, 2);
  const std::vector<Placed> touching{
      {"a cylinder stands on a box", unit_box, at(cylinder(1, 2), {0, 0, 3})},
      {"a cylinder stands on the rim of a box", unit_box, at(cylinder(1, 2), {mpq_class(3, 2), third, 3})},
      {"a cylinder lies on a box", unit_box, at(cylinder(1, 2), {0, 0, 2}, quarter_x)},
      {"a cylinder on a cylinder", cylinder(1, 1), at(cylinder(2, 1), {0, 0, 2})},
      {"a cylinder beside a cylinder", cylinder(1, 1), at(cylinder(2, 1), {3, 0, half})},
      {"a cylinder beside a cylinder, 3-4-5", cylinder(1, 1), at(cylinder(4, 1), {3, 4, half})},
      {"cylinders cross", cylinder(1, 2), at(cylinder(1, 3), {2, 0, 0}, quarter_x)},
      {"a ball on a face", unit_box, at(ball(1), {0, third, 2})},
      {"an ellipsoid on a face", unit_box, at(ellipsoid({1, 2, 3}), {half, 0, 4})},
      {"an ellipsoid on an ellipsoid", ellipsoid({1, 2, 3}), at(ellipsoid({3, 2, 1}), {0, 0, 4})},
      {"the apex of a cone on a face", unit_box, at(cone(1, 2), {0, half, 3}, half_x)},
      {"the base of a cone on a face", unit_box, at(cone(1, 2), {half, 0, 3})},
      {"a rim on a face", box({4, 4, 1}), at(cylinder(5, 5), {0, 0, 8}, {3, 1, 0, 0})},
      {"two balls", ball(2), at(ball(3), {3, 4, 0})},
      {"a ball in the hollow of no box: beside a cylinder", cylinder(1, 1), at(ball(4), {3, -4, third})},
      {"discs in one plane", disc(1), at(disc(1), {1, 0, 0})},
      {"a disc on a cylinder's end", cylinder(1, 1), at(disc(3), {0, 1, 1})},
      {"an ellipsoid with edges on a face", box({2, 2, 2}),
       at(minkowski_sum(ellipsoid({1, 2, 3}), unit_box), {0, 0, 6})},
      {"cones along a generator", cone(1, 1), at(cone(1, 1), {1, 0, 0}, half_x)},
      {"a cylinder along a cone", cone(3, 2),
       at(cylinder(1, third), {mpq_class(23, 10), 0, mpq_class(3, 5)}, along_generator)},
      {"a cylinder across a cone", cone(3, 2),
       at(cylinder(1, 2, Axis::y), {mpq_class(23, 10), third, mpq_class(3, 5)})},
      {"a ball on a cone's side", at(ball(5), {mpq_class(11, 2), 0, 3}), cone(3, 2)},
      {"rims that cross", cylinder(5, 1), at(cylinder(5, 1), {3, 0, 2}, {1, 0, 0, 2})},
      {"a rim on a barrel", cylinder(1, 3, Axis::y),
       at(cylinder(1, 1), {mpq_class(-1, 5), 0, mpq_class(12, 5)}, {3, 0, 1, 0})},
      {"an apex on the rim of an end", cylinder(5, 1), at(cone(1, 2), {3, 4, 3}, half_x)},
      {"a corner on the rim of an end", cylinder(5, 1), at(unit_box, {4, 5, 2})},
      {"a ball on the rim of an end", cylinder(5, 1), at(ball(2), {3, 4, 3})},
      {"a ball a hair inside of the rim", cylinder(5, 1), at(ball(2), {3, 4 - mpq_class(1, mpz_class(1) << 90), 3})},
      {"an ellipsoid on the rim of a sum", minkowski_sum(cylinder(5, 1), ball(1)), at(ellipsoid({1, 2, 3}), {3, 4, 5})},
      {"an end beside an edge, in one plane", cylinder(5, 1), at(unit_box, {mpq_class(9, 2), 4, 2}, {3, 0, 0, 1})},
      {"an end beside an end, in one plane", cylinder(5, 1),
       at(minkowski_sum(cylinder(1, third), unit_box), {mpq_class(23, 5), mpq_class(29, 5), mpq_class(7, 3)})},
      {"a corner beside two ends, in one plane", minkowski_sum(cylinder(2, 1), at(cylinder(3, 1), {1, 0, 0})),
       at(unit_box, {5, 5, 3})},
      {"a cylinder on a plane", halfspace({0, 0, 1}, 1), at(cylinder(1, 2), {7, 8, 3})},
      {"a cylinder lies on a plane", halfspace({0, 0, 1}, 1), at(cylinder(1, 2), {7, 8, 2}, quarter_x)},
      {"a sphere on a slope", halfspace({1, 2, 2}, 3),
       at(ball(1), {mpq_class(2, 3), mpq_class(4, 3), mpq_class(4, 3)})}};
  for (const Placed& placed : touching) expect_exactly(placed, 0);
}

// Normal n and unit vectors y are chosen; the radii are such that an ellipsoid has the normal n at
// y.
TEST(CurvedBounds, DecideTouchingOfEllipsoidsAtRationalPoints) {
  ShapeMaker make{families::Random(11), 4};
  const auto small = [&] {
    return Quaternion{make.random.between(1, 5), make.random.between(-5, 5), make.random.between(-5, 5), 2};
  };
  const auto of_pose = [](const Quaternion& q, const Point& p) {
    const Pose pose = rigid_pose(q, {});
    std::array<mpq_class, 3> result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = pose[i][0] * p.x + pose[i][1] * p.y + pose[i][2] * p.z;
    return Point{result[0], result[1], result[2]};
  };
  const Pose odd =
      rigid_pose({exact_value(0.3), exact_value(0.1), exact_value(-0.7), exact_value(0.52)}, {mpq_class(1, 3), 1, -2});
  for (int pairs = 0; pairs < 60;) {
    const Point n{make.random.between(-20, 20), make.random.between(-20, 20), make.random.between(1, 20)};
    std::array<Shape, 2> shapes;
    bool proper = true;
    for (int i = 0; i < 2 && proper; ++i) {
      const Quaternion turn = small();
      const Point m = of_pose({turn.w, -turn.x, -turn.y, -turn.z}, i == 0 ? n : Point{-n.x, -n.y, -n.z}),
                  y = of_pose(small(), {0, 0, 1});
      proper = m.x * m.y * m.z * y.x * y.y * y.z != 0;
      if (!proper) break;
      const Point r{abs(y.x / m.x), abs(y.y / m.y), abs(y.z / m.z)};
      const Point there =
          of_pose(turn, {r.x * r.x * m.x, r.y * r.y * m.y, r.z * r.z * m.z});  // r y, with the signs of m
      shapes[static_cast<std::size_t>(i)] = at(ellipsoid(r), {-there.x, -there.y, -there.z}, turn);
    }
    if (!proper) continue;
    ++pairs;
    const auto& [a, b] = shapes;
    for (const bool turned : {false, true}) {
      const CurvedBounds bounds = turned ? bounds_of(moved(a, odd), moved(b, odd)) : bounds_of(a, b);
      EXPECT_TRUE(bounds.low == 0 && bounds.high == 0)
          << pairs << (turned ? ", turned" : "") << ": [" << bounds.low << ", " << bounds.high;
    }
  }
}

// Of these fans of common normals no member is short.
TEST(CurvedBounds, DecideTouchesWhoseNormalsFormAFan) {
  const auto q = [](long above, long below) { return kernels::ratio(mpz_class(above), mpz_class(below)); };
  const std::vector<Placed> touching{
      {"an apex on an edge", at(cone(q(5, 4), q(13, 16)), {q(-607, 720), q(31, 18), q(167, 90)}, {5, 7, -5, 9}),
       at(box({q(15, 2), 5, 2}), {q(89, 288), q(-377, 72), q(89, 36)}, {12, 1, -10, -4})},
      {"an apex on a rim",
       at(cone(q(48, 13), q(10, 13)), {q(-396037, 764556), q(2033999, 764556), q(-183970, 191139)},
          {1199, 233, 273, 373}),
       at(cone(10, 7), {q(90475, 58812), q(-128837, 58812), q(58948, 14703)}, {245, -416, -787, 18})}};
  for (const Placed& placed : touching) {
    const CurvedBounds bounds = bounds_of(placed.a, placed.b);
    EXPECT_EQ(bounds.low, 0) << placed.what;
    EXPECT_EQ(bounds.high, 0) << placed.what;
  }
}

TEST(CurvedBounds, MeetWhereTheNearestFeaturesAreRational) {
  expect_exactly({"a gap between a cylinder and a box", unit_box, at(cylinder(1, 1), {0, 0, mpq_class(7, 3)})},
                 mpq_class(-1, 3));
  expect_exactly({"a gap between balls", ball(1), at(ball(3), {3, 4, 0})}, -1);
  expect_exactly({"a cylinder sunk into a box", box({3, 3, 3}), at(cylinder(1, 2), {0, 0, 4})}, 1);
  expect_exactly({"coaxial cylinders, along the axis", cylinder(3, 1), at(cylinder(3, 1), {0, 0, mpq_class(3, 2)})},
                 mpq_class(1, 2));
  expect_exactly({"boxes", unit_box, at(unit_box, {mpq_class(1, 2), 0, mpq_class(3, 2)})}, mpq_class(1, 2));
  expect_exactly({"margins close a gap", with_margin(unit_box, mpq_class(1, 12)),
                  at(with_margin(cylinder(1, 1), mpq_class(1, 4)), {0, 0, mpq_class(7, 3)})},
                 0);
  expect_exactly({"a plane cuts a cylinder", halfspace({0, 0, 1}, 1), at(cylinder(1, 2), {7, 8, 2})}, 1);
}

// Whether low <= rational + signed root of x <= high.
void expect_around(const CurvedBounds& bounds, const Surd& value, const char* what) {
  EXPECT_LE(compare(Surd{bounds.low, 0}, value), 0) << what;
  EXPECT_GE(compare(Surd{bounds.high, 0}, value), 0) << what;
}

TEST(CurvedBounds, OfEllipsoidsThatAreBallsHoldTheClosedForm) {
  ShapeMaker make{families::Random(5), 10};
  for (int i = 0; i < 60; ++i) {
    const mpq_class r = make.length(), s = make.length();
    const Point c = make.point(i % 3 == 0 ? 4 : 2);
    const mpq_class square = c.x * c.x + c.y * c.y + c.z * c.z;
    const Quaternion q = make.rotation(), p = make.rotation();
    const CurvedBounds bounds = bounds_of(at(ball(r), {0, 0, 0}, q), at(ball(s), c, p));
    expect_around(bounds, {r + s, -square}, "balls");
    if (bounds.support_calls < 5000) {
      EXPECT_LE((bounds.high - bounds.low) * (mpz_class(1) << 40), 6 * (r + s));
    }
  }
}

TEST(CurvedBounds, EndByTheirBudgetWhereOptimaFormAContinuum) {
  const Shape bar = cylinder(1, 4);
  const mpq_class tenth(1, 10), thousandth(1, 1000);
  const std::vector<std::pair<Placed, mpq_class>> hard{
      {{"coaxial cylinders", bar, bar}, 2},
      {{"nearly coaxial cylinders", bar, at(bar, {thousandth / 100, 0, 0})}, 2 - thousandth / 100},
      {{"balls with near centers", ball(1), at(ball(1), {thousandth, 0, 0})}, 2 - thousandth},
      {{"concentric balls", ball(1), ball(1)}, 2}};
  for (const auto& [placed, value] : hard) {
    for (const std::size_t budget : {10U, 100U, 500U}) {
      const CurvedBounds bounds = bounds_of(placed.a, placed.b, 40, budget, false);
      expect_around(bounds, {value, 0}, placed.what);
      EXPECT_GE(bounds.support_calls + 1, std::min<std::size_t>(budget, 256)) << placed.what;
      EXPECT_GE(bounds.low, budget < 100 ? mpq_class(0) : mpq_class(19, 10)) << placed.what;
      EXPECT_LT(bounds.high - value, tenth / 100) << placed.what;
    }
  }
}

// The root of 2 to 2^-bits, from below or above.
mpq_class root_of_two(unsigned bits, bool above) {
  const mpz_class scaled = mpz_class(2) << (2 * bits);
  mpq_class root(mpz_class(sqrt(scaled) + (above ? 1 : 0)), mpz_class(1) << bits);
  root.canonicalize();
  return root;
}

TEST(CurvedBounds, DecideTheStatusOfGrazingBodies) {
  for (const unsigned bits : {1U, 40U, 100U}) {
    for (const unsigned fine : {20U, 60U, 100U, 140U}) {
      for (const bool apart : {false, true}) {
        const mpq_class x = root_of_two(fine, apart);
        const CurvedBounds grazing = bounds_of(ball(1), at(ball(1), {x, x, 0}), bits);
        EXPECT_TRUE(apart ? grazing.high < 0 : grazing.low > 0) << bits << " bits, " << fine;
        expect_around(grazing, {2, -2 * x * x}, "grazing balls");
        const CurvedBounds margins = bounds_of(with_margin(ball(mpq_class(3, 4)), mpq_class(1, 8)),
                                               at(with_margin(ball(1), mpq_class(1, 8)), {x, x, 0}), bits);
        EXPECT_TRUE(apart ? margins.high < 0 : margins.low > 0) << bits << " bits, " << fine << ", margins";
      }
    }
  }
  const mpq_class hair = mpq_class(1, mpz_class(1) << 60);
  const Shape lying = at(cylinder(1, 2), {0, 0, 0}, {3, 1, 0, 0}),
              slope = halfspace({0, 0, 1}, mpq_class(-11, 5) + hair);
  EXPECT_EQ(bounds_of(slope, lying).low, hair);
  EXPECT_LT(bounds_of(halfspace({1, 1, 0}, -root_of_two(60, true)), cylinder(1, 2)).high, 0);
}

TEST(CurvedBounds, SayWhenTheyCannotDecide) {
  const mpq_class x = root_of_two(300, true);
  const CurvedBounds grazing = bounds_of(ball(1), at(ball(1), {x, x, 0}));
  EXPECT_LT(grazing.low, 0);
  EXPECT_GT(grazing.high, 0);
  EXPECT_LE((grazing.high - grazing.low) * (mpz_class(1) << 160), 6);
  expect_around(grazing, {2, -2 * x * x}, "grazing balls");
  // They touch, but their one common normal, (1, 1, sqrt(2)), is irrational.
  const CurvedBounds irrational = bounds_of(cone(1, mpq_class(1, 2)), at(ball(1), {1, 1, mpq_class(1, 2)}));
  EXPECT_LT(irrational.low, 0);
  EXPECT_GT(irrational.high, 0);
  expect_around(irrational, {0, 0}, "a ball on a cone");
  const CurvedBounds finer = bounds_of(ball(1), at(ball(1), {x, x, 0}), 310);
  EXPECT_LT(finer.high, 0);
  expect_around(finer, {2, -2 * x * x}, "grazing balls, looked at closely");
}

TEST(CurvedBounds, EndBeforeTheirBudgetWhereItWillNotDo) {
  const Shape bar = cylinder(1, 4);
  const auto bounds_in_space = [](const Shape& a, const Shape& b, unsigned bits = 40, std::size_t calls = 5000) {
    return bounds_of(a, b, bits, calls, false);
  };
  const CurvedBounds around_axis = bounds_in_space(bar, bar), around_center = bounds_in_space(ball(1), ball(1));
  EXPECT_EQ(around_axis.support_calls, 512);
  EXPECT_GT(around_axis.low * 10000, 19998);
  EXPECT_EQ(around_center.support_calls, 512);
  EXPECT_GT(around_center.low * 100, 198);
  EXPECT_GT(bounds_in_space(bar, bar, 20).support_calls,
            512);  // it is their share of the goal that counts, and of the budget
  EXPECT_GT(bounds_in_space(bar, bar, 26, 20000).support_calls, 512);
  EXPECT_EQ(bounds_in_space(bar, bar, 26).support_calls, 512);
  const CurvedBounds slow = bounds_of(bar, at(bar, {mpq_class(1, 1000), 0, 0}));  // but it gets on
  EXPECT_LE((slow.high - slow.low) * (mpz_class(1) << 40), 16);
  EXPECT_GT(slow.support_calls, 1024);
  // The status is not given away: the cores only just penetrate.
  const Shape thin = cylinder(mpq_class(1, mpz_class(1) << 45), 4);
  EXPECT_GT(bounds_in_space(thin, thin).low, 0);
  EXPECT_GT(bounds_of(thin, thin).low, 0);
}

TEST(CurvedBounds, KeepTheirWidthWhateverItIs) {
  const Shape a = at(cylinder(1, 2), {0, 0, 0}, {3, 1, 2, 5}),
              b = at(ellipsoid({1, 2, 1}), {1, 1, mpq_class(1, 3)}, {1, 7, 3, 1});
  mpq_class low = -100, high = 100;
  for (const unsigned bits : {1U, 5U, 20U, 40U, 60U, 120U}) {
    const CurvedBounds bounds = bounds_of(a, b, bits);
    EXPECT_LE((bounds.high - bounds.low) * (mpz_class(1) << bits), 12) << bits;
    EXPECT_LE(bounds.low, high) << bits;
    EXPECT_GE(bounds.high, low) << bits;
    low = std::max(low, bounds.low);
    high = std::min(high, bounds.high);
  }
}

TEST(CurvedBounds, OfSmallAndLargeNumbersAreThoseOfOrdinaryOnes) {
  const mpq_class tiny = exact_value(0x1p-1000), large = exact_value(0x1p1000);
  const auto pair_of = [](const mpq_class& s) {
    return std::pair(at(cylinder(s, 2 * s), {0, 0, 0}, {3, 1, 2, 5}),
                     at(ellipsoid({s, 2 * s, s}), {s, s, s / 3}, {1, 7, 3, 1}));
  };
  const auto [a, b] = pair_of(1);
  const CurvedBounds ordinary = bounds_of(a, b);
  for (const mpq_class& s : {tiny, large}) {
    const auto [c, d] = pair_of(s);
    const CurvedBounds bounds = bounds_of(c, d);
    EXPECT_EQ(bounds.low, ordinary.low * s);
    EXPECT_EQ(bounds.high, ordinary.high * s);
  }
  // Of both at once.
  const CurvedBounds mixed = bounds_of(cylinder(large, tiny), at(cylinder(tiny, tiny), {large / 2, 0, 3 * tiny}));
  EXPECT_LE(mixed.low, -tiny);
  EXPECT_GE(mixed.high, -tiny);
}

// Bounds agree in all bits of binary64 long before they are near enough: nevertheless the facets,
// whose numbers are long, are seldom compared.
TEST(CurvedBounds, TakeFewScansForManyBits) {
  const mpq_class tiny = exact_value(1e-200), large = exact_value(1e308);
  const Quaternion q{1, 2, 3, 4};
  const CurvedBounds fine = bounds_of(cone(tiny, large), at(cylinder(large, tiny), {0, 0, 0}, q), 300);
  EXPECT_GT(fine.support_calls, 400);
  EXPECT_LE(fine.facet_scans, 2);
  EXPECT_LE((fine.high - fine.low) * (mpz_class(1) << 300), 8 * large);
  // O is so near to the boundary of P, for its size, that squares are 0 in binary64.
  const CurvedBounds thin = bounds_of(at(cylinder(exact_value(1e100), large), {0, 0, 0}, q),
                                      at(cylinder(tiny, 1), {tiny, 0, tiny}, {7, -1, 4, -6}), most_bound_bits);
  EXPECT_GE(thin.support_calls, 512);
  EXPECT_LE(thin.facet_scans, 160);
}

TEST(CurvedBounds, OfDegenerateAtoms) {
  const Shape point = ShapeMaker::one_atom({{1, 2, 3}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}});
  EXPECT_EQ(bounds_of(point, point).high, 0);
  EXPECT_EQ(bounds_of(point, point).low, 0);
  const Shape segment = ShapeMaker::one_atom({{0, 0, 0}, {{1, 0, 0}, {0, 0, 0}}}),
              same = ShapeMaker::one_atom({{0, 0, 0}, {{3, 0, 0}, {4, 0, 0}}});
  EXPECT_EQ(bounds_of(segment, at(same, {6, 0, 0})).high, 0);  // the second reaches 5 to the left
  EXPECT_EQ(bounds_of(segment, at(same, {7, 0, 0})).low, -1);
  const CurvedBounds crossing = bounds_of(disc(1), at(disc(1), {mpq_class(1, 2), 0, 0}, quarter_x));
  EXPECT_GT(crossing.low, 0);  // flat bodies overlap where no translation by less parts them
  expect_around(crossing, {1, 0}, "crossing discs");
}

TEST(CurvedBounds, AreWhatSignedDepthSaysOfCurvedShapes) {
  const SignedDepth standing = signed_depth(unit_box, at(cylinder(1, 2), {0, 0, 3}));
  ASSERT_NE(standing.exact(), nullptr);
  EXPECT_EQ(standing.status(), Status::touching);
  EXPECT_EQ(standing.direction(), (Vector{0, 0, -1}));
  const Shape leaning = at(cylinder(1, 2), {0, 0, 3}, {5, 1, 1, 0});
  const SignedDepth deep = signed_depth(unit_box, leaning);
  ASSERT_NE(deep.bounds(), nullptr);
  EXPECT_EQ(deep.status(), Status::penetrating);
  EXPECT_LT(deep.low_binary64(), deep.high_binary64());
  EXPECT_TRUE(std::holds_alternative<Bracket>(deep.core));
  SignedDepthOptions options;
  options.cores.validate = true;
  options.bits = 10;
  EXPECT_LE(signed_depth(unit_box, leaning, options).bounds()->low, deep.bounds()->low);
  options.support_calls = 0;  // still proved
  EXPECT_GE(signed_depth(unit_box, leaning, options).bounds()->high, deep.bounds()->low);
  options.bits = most_bound_bits + 1;
  EXPECT_THROW(signed_depth(unit_box, leaning, options), std::invalid_argument);
  const SignedDepth on_slope = signed_depth(halfspace({1, 2, 2}, 3), leaning);
  ASSERT_NE(on_slope.bounds(), nullptr);
  EXPECT_EQ(on_slope.status(), Status::penetrating);
}

TEST(CurvedBounds, RefuseNumbersThatShareNoDenominator) {
  Term term{{{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}}}}};
  for (int i = 0; i < 200; ++i) term.atoms.push_back({{mpq_class(1, (mpz_class(1) << 20000) + 2 * i + 1), 0, 0}, {}});
  EXPECT_THROW(bounds_of(Shape{std::vector<Term>{term}, 0}, unit_box), InputError);
}

TEST(CurvedBounds, StopWhenTheMonitorSaysSo) {
  struct Stopper : Monitor {
    void report(std::string_view, double) override { ++reports; }
    bool stopped() override { return reports > 20; }
    int reports = 0;
  } stopper;
  kernels::Context context(&stopper);
  EXPECT_THROW(signed_bounds(context, ball(1), at(ball(1), {mpq_class(1, 100), 0, 0}), 40, 5000, false), Interrupted);
}

// Every part of a proof matters.
TEST(CurvedBounds, ForgedAreRefused) {
  const Shape a = at(cylinder(1, 2), {0, 0, 0}, {3, 1, 2, 5}),
              b = with_margin(at(ellipsoid({1, 2, 1}), {1, 1, 0}, {1, 7, 3, 1}), mpq_class(1, 8));
  const Shape far = at(b, {5, 0, 0});
  const CurvedBounds deep = bounds_of(a, b), apart = bounds_of(a, far);
  const auto refused = [&](const CurvedBounds& bounds, const Shape& x, const Shape& y) {
    return !validate(bounds, x, y).ok();
  };
  const mpq_class step(1, mpz_class(1) << 30);
  CurvedBounds forged = deep;
  forged.low += step;
  EXPECT_TRUE(refused(forged, a, b));
  forged = deep;
  forged.high -= step;
  EXPECT_TRUE(refused(forged, a, b));
  forged = deep;
  forged.bracket.heights_a[0] *= mpq_class(999, 1000);
  EXPECT_TRUE(refused(forged, a, b));
  forged = deep;
  for (InnerPoint& point : forged.bracket.inner_b) point[0].local[0] += mpq_class(1, 10);
  EXPECT_TRUE(refused(forged, a, b));
  forged = deep;
  forged.bracket.polytope.facets.pop_back();
  EXPECT_TRUE(refused(forged, a, b));
  forged = apart;
  forged.bracket.weights_a[0].weight += step;
  EXPECT_TRUE(refused(forged, a, far));
  forged = apart;
  forged.low += step;
  EXPECT_TRUE(refused(forged, a, far));
  Shape without = b;
  without.radius = 0;
  EXPECT_TRUE(refused(deep, a, without));
}

}  // namespace
}  // namespace fathom::curved
