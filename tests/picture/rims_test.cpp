// SPDX-License-Identifier: GPL-3.0-or-later
// Rims: where the ends of cylinders, cones and frusta meet their sides; the half behind is hidden.
// A naive twin finds what is seen by rays.
#include <gtest/gtest.h>

#include <cmath>

#include "fathom/numbers.hpp"
#include "view/picture/drawn.hpp"
#include "view/picture/paint.hpp"

namespace fathom::picture {
namespace {

/// x to the right, z up and a little towards us: the cap of a cylinder along z is seen.
View from_above() { return {Point{1, 0, 0}, Point{0, 1, 2}}; }
/// z up, exactly: caps are seen from their edges.
View from_beside() { return {Point{1, 0, 0}, Point{0, 0, 1}}; }

std::vector<Rim> rims(const Shape& shape, const View& view) { return std::get<Curved>(drawn_shape(shape, view)).rims; }

std::size_t points(const std::vector<Rim>& rims, bool hidden) {
  std::size_t result = 0;
  for (const Rim& rim : rims)
    if (rim.hidden == hidden) result += rim.path.size() - 1;
  return result;
}

double radius(const Point& p) { return std::hypot(p.x.get_d(), p.y.get_d()); }

TEST(Rims, ACylinderHasTwo) {
  const std::vector<Rim> found = rims(cylinder(2, 3), from_above());
  ASSERT_EQ(found.size(), 3u) << "law: the upper rim is seen; of the lower one a half is hidden";
  EXPECT_EQ(points(found, false), 96u + 48u);
  EXPECT_EQ(points(found, true), 48u);
  for (const Rim& rim : found)
    for (const Point& p : rim.path) {
      EXPECT_NEAR(radius(p), 2, 1e-12);
      EXPECT_NEAR(std::abs(p.z.get_d()), 3, 1e-12);
      const double nearness = dot(Vec3<double>{p.x.get_d(), p.y.get_d(), 0}, from_above().towards());
      EXPECT_TRUE(!rim.hidden || nearness < 0.2) << "law: the far side is hidden";
    }
}

TEST(Rims, OfOtherBodies) {
  EXPECT_EQ(rims(cone(2, 3), from_above()).size(), 2u) << "a cone has one, half of it behind";
  EXPECT_EQ(rims(frustum(2, 1, 3), from_above()).size(), 3u);
  EXPECT_EQ(rims(cone(2, 3, Axis::y), from_above()).size(), 1u) << "seen from its base";
  EXPECT_TRUE(rims(sphere(1), from_above()).empty());
  EXPECT_TRUE(rims(capsule(1, 2), from_above()).empty());
  EXPECT_TRUE(rims(ellipsoid({1, 2, 3}), from_above()).empty());
  EXPECT_TRUE(rims(with_margin(cylinder(1, 2), mpq_class(1, 10)), from_above()).empty())
      << "what is rounded has no edges";
  EXPECT_EQ(points(rims(cylinder(2, 3), from_beside()), true), 0u) << "law: an end seen from its edge hides nothing";
}

TEST(Rims, OfAFlatConeAllOfItIsSeen) {
  const std::vector<Rim> found =
      rims(cone(10, mpq_class(1, 4)), from_above());  // the apex points to us more than its side is steep
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].hidden);
}

/// Whether a point just before p, towards us, is outside: the support function in many directions
/// says so.
bool naive_is_seen(const std::vector<Vec3<double>>& samples, const Vec3<double>& p, const Vec3<double>& towards) {
  const Vec3<double> before{p.x + 1e-3 * towards.x, p.y + 1e-3 * towards.y, p.z + 1e-3 * towards.z};
  for (int i = 0; i < 200; ++i)
    for (int j = 0; j < 400; ++j) {
      const double polar = M_PI * i / 200, turn = 2 * M_PI * j / 400;
      const Vec3<double> u{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)};
      double reach = -1e9;
      for (const Vec3<double>& s : samples) reach = std::max(reach, dot(s, u));
      if (dot(before, u) > reach + 2e-5) return true;
    }
  return false;
}

TEST(Rims, AgreeWithRays) {
  std::vector<Vec3<double>> samples{{0, 0, 3}};  // a cone: apex and rim
  for (int i = 0; i < 96; ++i)
    samples.push_back({2 * std::cos(2 * M_PI * i / 96), 2 * std::sin(2 * M_PI * i / 96), -3});
  const View view = from_above();
  int compared = 0;
  for (const Rim& rim : rims(cone(2, 3), view))
    for (std::size_t i = 4; i + 4 < rim.path.size(); i += 8) {  // not where it begins and ends
      const Point& p = rim.path[i];
      EXPECT_EQ(naive_is_seen(samples, {p.x.get_d(), p.y.get_d(), p.z.get_d()}, view.towards()), !rim.hidden);
      ++compared;
    }
  EXPECT_GT(compared, 8);
}

TEST(Rims, ArePaintedFarAwayAndOfAnySize) {
  for (const mpq_class& unit : {mpq_class(1), exact_value(1e300), exact_value(1e-300)}) {
    const mpq_class far = 1000 * unit;
    const Shape a = moved(cylinder(unit, unit), {{{1, 0, 0, far}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
    const Shape b =
        moved(cylinder(unit, unit), {{{1, 0, 0, mpq_class(far + unit)}, {0, 1, 0, 0}, {0, 0, 1, mpq_class(unit / 3)}}});
    const PairScene scene = scene_of(a, b, signed_depth(a, b));
    const std::string text = painted(scene, panels_of(scene, {400, 300}).front(), "x");
    EXPECT_NE(text.find("body-a hidden"), std::string::npos);
    EXPECT_NE(text.find("body-b hidden"), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
  }
}

}  // namespace
}  // namespace fathom::picture
