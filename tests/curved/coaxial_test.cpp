// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of revolution about one axis: against closed forms, against the general search, and in
// poses that no machine number holds.
#include <gtest/gtest.h>

#include "kernels/number/irrational.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "reference/shapes/core.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/random_shapes.hpp"

namespace fathom::curved {
namespace {

using testing::ShapeMaker;

/// No machine number holds it.
Pose odd() {
  return rigid_pose({exact_value(0.3), exact_value(0.1), exact_value(-0.7), exact_value(0.52)},
                    {mpq_class(1, 3), 1, -2});
}

CurvedBounds bounds_about(const Shape& a, const Shape& b, bool coaxial = true, unsigned bits = 40) {
  kernels::Context context;
  const Shape simple_a = shapes::simplified(a), simple_b = shapes::simplified(b);
  CurvedBounds bounds = signed_bounds(context, simple_a, simple_b, bits, 5000, coaxial);
  const kernels::Report report = coaxial ? validate(bounds, simple_a, simple_b) : kernels::Report{};
  EXPECT_TRUE(report.ok()) << testing::text(report);
  return bounds;
}

Shape above(const Shape& shape, const mpq_class& z) { return moved(shape, rigid_pose({1, 0, 0, 0}, {0, 0, z})); }

struct Known {
  const char* what;
  Shape a, b;
  Surd depth;
};

TEST(Coaxial, DepthsInClosedForm) {
  const mpq_class half(1, 2), quarter(1, 4);
  const Shape drum = cylinder(2, 6), top = cone(3, 2);
  const std::vector<Known> all{
      {"a capsule in a cylinder", capsule(half, 3), drum, {half + 2, 0}},
      {"a sphere in a cylinder", sphere(half), above(drum, 1), {half + 2, 0}},
      {"a sphere near the end of a cylinder", sphere(half), above(drum, 5), {half + 1, 0}},
      {"equal cylinders", drum, drum, {4, 0}},
      {"a cylinder in a cylinder", cylinder(1, 1), drum, {3, 0}},
      {"a cylinder with a margin", with_margin(cylinder(1, 1), quarter), drum, {3 + quarter, 0}},
      // the side of the cone has the normal (3, 4): along the axis, away from it; height 6
      {"a point of a cone's axis", sphere(half), top, {half + mpq_class(6, 5), 0}},
      {"a cone on a disc", cone(1, 2), above(cylinder(1, quarter), -2), {quarter, 0}},
      // normal (1, 4), height 2
      {"a cone of an irrational side", sphere(half), cone(1, 2), {half, mpq_class(4, 17)}},
      {"an ellipsoid in a cylinder", ellipsoid({1, 1, 3}), drum, {3, 0}},
      // of the hull of -2 and the unit ball around 2 the height is max(-2 a, 2 a + 1)
      {"a sphere in a tapered capsule", sphere(half), tapered_capsule(1, 2, 2), {2, 0}},
      {"a cylinder in a tapered capsule",
       cylinder(1, 1),
       tapered_capsule(1, 2, 2),
       {mpq_class(7, 4), mpq_class(15, 16)}},
      {"a capsule in a tapered capsule, an arc around O",
       capsule(half, 2),
       tapered_capsule(1, 2, 2),
       {mpq_class(5, 2), 0}},
      {"a tapered capsule around its larger end", sphere(1), above(tapered_capsule(1, 2, 2), -2), {3, 0}}};
  for (const Known& known : all) {
    for (const bool turned : {false, true}) {
      for (const bool swapped : {false, true}) {
        const Shape a = turned ? moved(known.a, odd()) : known.a, b = turned ? moved(known.b, odd()) : known.b;
        const CurvedBounds bounds = swapped ? bounds_about(b, a) : bounds_about(a, b);
        const std::string where = std::string(known.what) + (turned ? ", turned" : "") + (swapped ? ", swapped" : "");
        ASSERT_TRUE(bounds.exact) << where << bounds.low.get_d() << ' ' << bounds.high.get_d();
        EXPECT_EQ(compare(*bounds.exact, known.depth), 0) << where << ": " << kernels::exact_surd_text(*bounds.exact);
        EXPECT_LE(compare(Surd{bounds.low, 0}, known.depth), 0) << where;
        EXPECT_GE(compare(Surd{bounds.high, 0}, known.depth), 0) << where;
      }
    }
  }
}

/// Bodies of revolution about the z-axis.
Shape turned_body(ShapeMaker& make) {
  const mpq_class r = make.length(), s = make.length(), t = make.length();
  switch (make.random.between(0, 7)) {
    case 0: return cylinder(r, s);
    case 1: return cone(r, s);
    case 2: return frustum(r, s, t);
    case 3: return ellipsoid({r, r, s});
    case 4: return tapered_capsule(r, s, t);
    case 5: return capsule(r, s);
    case 6: return with_margin(minkowski_sum(ellipsoid({r, r, s}), cone(s, t)), t / 4);
    default: return sphere(r);
  }
}

// Each proof is checked by the definitions; the general search is the twin, and so is that of arcs.
TEST(Coaxial, BoundsAreNarrowAndThoseOfTheGeneralSearchHoldThem) {
  ShapeMaker make{families::Random(36), 6};
  int exact = 0, deep = 0, arcs = 0;
  for (int i = 0; i < 120; ++i) {
    const Shape a = turned_body(make), b = above(turned_body(make), make.length() - 1);
    const Quaternion q = make.rotation();
    const Pose pose = rigid_pose(q, make.point(3));
    const Shape c = moved(a, pose), d = moved(b, pose);
    const CurvedBounds near = bounds_about(c, d);
    const CurvedBounds wide = bounds_about(c, d, false);
    EXPECT_LE(wide.low, near.high) << i;
    EXPECT_GE(wide.high, near.low) << i;
    if (near.bracket.around) EXPECT_LE((near.high - near.low) * (mpz_class(1) << 40), 32) << i;
    deep += near.bracket.around.has_value();
    if (!near.exact) continue;
    ++exact;
    EXPECT_LE(compare(Surd{near.low, 0}, *near.exact), 0) << i;
    EXPECT_GE(compare(Surd{near.high, 0}, *near.exact), 0) << i;
    const auto profile = common_profile(std::get<std::vector<Term>>(shapes::simplified(c).core),
                                        std::get<std::vector<Term>>(shapes::simplified(d).core));
    ASSERT_TRUE(profile);
    const auto by_arcs = depth_of_arcs(*profile);
    if (!by_arcs) continue;
    ++arcs;
    EXPECT_EQ(compare(Surd{by_arcs->depth.rational + c.radius + d.radius, by_arcs->depth.root}, *near.exact), 0) << i;
  }
  EXPECT_GE(deep, 60);
  EXPECT_GE(exact, 40);
  EXPECT_GE(arcs, 30);
}

// The twin alone, where every direction of the half-plane may be asked for: no height is less.
TEST(Coaxial, NoHeightIsLessThanTheDepth) {
  ShapeMaker make{families::Random(7), 5};
  for (int i = 0; i < 40; ++i) {
    const Shape a = turned_body(make), b = above(turned_body(make), make.length() - 1);
    const CurvedBounds bounds = bounds_about(a, b);
    for (int k = -8; k <= 8; ++k) {
      const Point u{8 - abs(k), 0, k};
      const kernels::RationalInterval height = shapes::support(b, u, 60) + shapes::support(a, -u, 60);
      EXPECT_GE(height.high, bounds.low) << i;
      if (bounds.exact) EXPECT_LE(compare(*bounds.exact, height.high), 0) << i;
    }
  }
}

TEST(Coaxial, WidthFollowsTheBits) {
  const CurvedBounds smooth = bounds_about(ellipsoid({1, 1, 3}), ellipsoid({2, 2, 1}));
  EXPECT_EQ(smooth.high, 3);
  EXPECT_GT(smooth.low, 3 - mpq_class(8, mpz_class(1) << 40));
  const Shape a = ellipsoid({1, 1, 2}), b = above(cone(2, 3), mpq_class(-5, 4));
  for (const unsigned bits : {10U, 60U, 300U}) {
    const CurvedBounds bounds = bounds_about(moved(a, odd()), moved(b, odd()), true, bits);
    EXPECT_TRUE(bounds.bracket.around);
    EXPECT_LE((bounds.high - bounds.low) * (mpz_class(1) << bits), 16) << bits;
    EXPECT_LT(bounds.support_calls, 600) << bits;
  }
}

TEST(Coaxial, OtherBodiesHaveNoCommonAxis) {
  const auto terms = [](const Shape& shape) { return std::get<std::vector<Term>>(shape.core); };
  const Shape drum = cylinder(1, 2);
  EXPECT_TRUE(common_profile(terms(drum), terms(moved(drum, rigid_pose({0, 1, 0, 0}, {0, 0, 1})))));
  EXPECT_FALSE(common_profile(terms(drum), terms(moved(drum, rigid_pose({1, 0, 0, 0}, {mpq_class(1, 1000), 0, 0})))));
  EXPECT_FALSE(common_profile(terms(drum), terms(moved(drum, rigid_pose({1000, 1, 0, 0}, {0, 0, 0})))));
  EXPECT_FALSE(common_profile(terms(drum), terms(ellipsoid({1, mpq_class(999, 1000), 2}))));
  EXPECT_FALSE(common_profile(terms(drum), terms(box({1, 1, 1}))));
  EXPECT_FALSE(bounds_about(drum, above(drum, 5)).bracket.around) << "they are apart";
}

// Every part of the proof matters.
TEST(Coaxial, ForgedAreRefused) {
  const Shape a = cylinder(1, 2), b = with_margin(ellipsoid({2, 2, 1}), mpq_class(1, 8)), cone_b = cone(2, 3);
  const CurvedBounds honest = bounds_about(a, cone_b);
  const auto refused = [&](const auto& forge) {
    CurvedBounds forged = honest;
    forge(forged, *forged.bracket.around);
    return !validate(forged, a, cone_b).ok();
  };
  const mpq_class step(1, mpz_class(1) << 20);
  EXPECT_FALSE(refused([](CurvedBounds&, Revolution&) {}));
  EXPECT_TRUE(refused([&](CurvedBounds& c, Revolution&) { c.low += step; }));
  EXPECT_TRUE(refused([](CurvedBounds&, Revolution& r) { r.axis = {0, 1, 1}; }));
  EXPECT_TRUE(refused([](CurvedBounds&, Revolution& r) { r.outline.pop_back(); }));
  EXPECT_TRUE(refused([](CurvedBounds&, Revolution& r) { r.outline.erase(r.outline.begin()); }));
  EXPECT_TRUE(refused([](CurvedBounds&, Revolution& r) { std::swap(r.outline[0], r.outline[1]); }));
  EXPECT_TRUE(refused([&](CurvedBounds&, Revolution& r) { r.points_b.back().front().r += step; }));
  EXPECT_TRUE(refused([&](CurvedBounds&, Revolution& r) { r.points_a.front().front().z -= step; }));
  EXPECT_TRUE(refused([](CurvedBounds&, Revolution& r) { r.points_a.front().front().atom = 7; }));
  EXPECT_FALSE(validate(honest, moved(a, rigid_pose({1, 0, 0, 0}, {step, 0, 0})), cone_b).ok());
  EXPECT_FALSE(validate(honest, a, b).ok());
}

}  // namespace
}  // namespace fathom::curved
