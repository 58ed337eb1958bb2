// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of random pairs: against the naive check, against other frames, and against prisms inside
// and outside of cylinders.
#include <gtest/gtest.h>

#include "fathom/depth.hpp"
#include "fathom/numbers.hpp"
#include "reference/curved/curved_bounds.hpp"
#include "tests/support/prepared.hpp"
#include "tests/support/random_shapes.hpp"
#include "verify/families/solids.hpp"

namespace fathom::curved {
namespace {

using testing::ShapeMaker;

CurvedBounds bounds_of(const Shape& a, const Shape& b, std::size_t support_calls = 1000) {
  kernels::Context context;
  return signed_bounds(context, a, b, 40, support_calls);
}

TEST(CurvedPairs, OfAllKindsHaveProofs) {
  std::array<int, 3> signs{};
  for (const unsigned bits : {4U, 40U}) {
    ShapeMaker make{families::Random(bits), bits};
    for (const std::string_view kind_a : ShapeMaker::kinds) {
      for (const std::string_view kind_b : ShapeMaker::kinds) {
        const Shape a = make.posed(make.shape(kind_a), 1), b = make.posed(make.shape(kind_b), 3);
        const CurvedBounds bounds = bounds_of(a, b);
        ++signs[bounds.low > 0 ? 0 : bounds.high < 0 ? 1 : 2];
        if (bounds.bracket.polytope.facets.size() > 60)
          continue;  // the naive check takes long; the checkers see them all
        const kernels::Report report = validate(bounds, a, b);
        EXPECT_TRUE(report.ok()) << kind_a << " and " << kind_b << ": " << testing::text(report);
      }
    }
  }
  EXPECT_GT(signs[0], 60);
  EXPECT_GT(signs[1], 60);
  EXPECT_LT(signs[2], 6);
}

TEST(CurvedPairs, HaveOneDepthInAllFrames) {
  ShapeMaker make{families::Random(3), 12};
  for (int i = 0; i < 150; ++i) {
    const Shape a = make.posed(make.any_shape(), 1), b = make.posed(make.any_shape(), 2);
    const Quaternion q = make.rotation();
    const Pose pose = rigid_pose(q, make.point(5));
    const std::array<CurvedBounds, 3> bounds{bounds_of(a, b), bounds_of(b, a),
                                             bounds_of(moved(a, pose), moved(b, pose))};
    for (const CurvedBounds& x : bounds)
      for (const CurvedBounds& y : bounds) EXPECT_LE(x.low, y.high) << i;
  }
}

// Corners of a prism with its edges on a cylinder, and of one with its faces outside. `step` is a
// corner's angle.
struct Prisms {
  std::vector<Point> inside, outside;
};
Prisms prisms(const mpq_class& radius, const mpq_class& half_length, const Pose& pose) {
  constexpr unsigned corners = 24, bits = 30;
  constexpr std::int64_t one = std::int64_t{1} << bits;
  const auto posed = [&](const mpq_class& x, const mpq_class& y, const mpq_class& z) {
    Point p;
    mpq_class* const coordinates[] = {&p.x, &p.y, &p.z};
    for (std::size_t i = 0; i < 3; ++i) *coordinates[i] = pose[i][0] * x + pose[i][1] * y + pose[i][2] * z + pose[i][3];
    return p;
  };
  Prisms result;
  for (unsigned k = 0; k < corners; ++k) {
    const families::CirclePoint p = families::circle_point(k, corners, bits);
    // Two units are more than the rounding; 1/cos(pi/24) is below 1.00864.
    const mpq_class in = radius / mpq_class(one + 2), out = radius / mpq_class(one - 2) * mpq_class(3152, 3125);
    for (const int side : {-1, 1}) {
      result.inside.push_back(posed(in * mpq_class(p.cosine), in * mpq_class(p.sine), side * half_length));
      result.outside.push_back(posed(out * mpq_class(p.cosine), out * mpq_class(p.sine), side * half_length));
    }
  }
  return result;
}

TEST(CurvedPairs, OfCylindersLieBetweenThoseOfPrisms) {
  ShapeMaker make{families::Random(8), 6};
  int penetrating = 0;
  for (int i = 0; i < 40; ++i) {
    const mpq_class r = make.length(), s = make.length(), t = make.length(), u = make.length();
    const Quaternion p = make.rotation(), q = make.rotation();
    const Pose pose_a = rigid_pose(p, make.point(1)), pose_b = rigid_pose(q, make.point(3));
    const Prisms a = prisms(r, s, pose_a), b = prisms(t, u, pose_b);
    const CurvedBounds bounds = bounds_of(moved(cylinder(r, s), pose_a), moved(cylinder(t, u), pose_b));
    const Surd inside{0, signed_square(penetration_depth(a.inside, b.inside))},
        outside{0, signed_square(penetration_depth(a.outside, b.outside))};
    EXPECT_LE(compare(inside, bounds.high), 0) << i;
    EXPECT_GE(compare(outside, bounds.low), 0) << i;
    EXPECT_LT(round_binary64(outside) - round_binary64(inside), 0.02 * (r.get_d() + t.get_d()))
        << i;  // they do confine
    penetrating += bounds.low > 0 ? 1 : 0;
  }
  EXPECT_GT(penetrating, 5);
  EXPECT_LT(penetrating, 35);
}

}  // namespace
}  // namespace fathom::curved
