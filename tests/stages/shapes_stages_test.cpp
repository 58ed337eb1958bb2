// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of shapes: sampled outlines and the contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fathom/signed_depth.hpp"
#include "reference/files/shape_names.hpp"
#include "tests/stages/staged_cases.hpp"
#include "verify/families/families.hpp"

namespace fathom::stages {
namespace {

using testing::dot;

Body at(const Shape& shape, const mpq_class& x) {
  const Pose pose{{{1, 0, 0, x}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  return files::body_of(moved(shape, pose));
}

TEST(Shapes, OutlinesLieOnTheBodies) {
  const Stages stages = stages_of(at(sphere(2), 0), at(cylinder(1, 3), 2));
  EXPECT_TRUE(stages.a.sampled && stages.b.sampled);
  for (const Place& p : stages.a.vertices) EXPECT_NEAR(std::sqrt(dot(p, p)), 2, 1e-5);
  double top = 0;
  for (const Place& p : stages.b.vertices) {
    EXPECT_NEAR(std::hypot(p[0] - 2, p[1]), 1, 1e-5);
    EXPECT_NEAR(std::abs(p[2]), 3, 1e-5);
    top = std::max(top, p[2]);
  }
  EXPECT_GT(stages.a.vertices.size(), 300U);
  EXPECT_GT(stages.b.vertices.size(), 50U);
  EXPECT_TRUE(stages.charts.empty() && stages.pairs.empty() && !stages.cutting && !stages.winner);
  EXPECT_EQ(stages.depth, 1.0);
  EXPECT_EQ(stages.squared, 1);
  EXPECT_EQ(stages.contact.direction, (Place{-1, 0, 0}));
}

TEST(Shapes, FacetsLookOutward) {
  const Stages stages = stages_of(at(cone(1, 1), 0), at(ellipsoid({1, 2, 3}), 1));
  for (const StagedBody* body : {&stages.a, &stages.b}) {
    Place middle{};
    for (const Place& p : body->vertices) {
      for (std::size_t i = 0; i < 3; ++i) middle[i] += p[i] / static_cast<double>(body->vertices.size());
    }
    for (const Indices& facet : body->facets) {
      const auto from = [&](std::size_t i) -> Place {
        const Place &p = body->vertices[facet[i]], &q = body->vertices[facet[0]];
        return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
      };
      const Place u = from(1), v = from(2);
      const Place normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      const Place& p = body->vertices[facet[0]];
      EXPECT_GT(dot(normal, {p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]}), 0);
    }
  }
}

TEST(Shapes, DepthIsThatOfSignedDepth) {
  for (const families::Family& family : families::families(families::Kind::shapes)) {
    const Case input = family.make(1, family.usual_size);
    const Shape a = files::shape_of(input.a), b = files::shape_of(input.b);
    const Stages stages = stages_of(input.a, input.b);
    const SignedDepth depth = signed_depth(a, b);
    EXPECT_EQ(stages.status, depth.status()) << input.id;
    if (depth.status() == Status::penetrating) {
      if (depth.exact()) {
        EXPECT_EQ(stages.depth, round_binary64(*depth.exact())) << input.id;
      } else {
        EXPECT_EQ(stages.depth.has_value(), round_binary64(depth.bounds()->low) == round_binary64(depth.bounds()->high))
            << input.id;
      }
      const double length = std::sqrt(dot(stages.contact.translation, stages.contact.translation));
      const double expected =
          depth.exact() ? *stages.depth : mpq_class((depth.bounds()->low + depth.bounds()->high) / 2).get_d();
      EXPECT_NEAR(length / std::exp2(stages.scale.exponent) / expected, 1, 1e-9) << input.id;
    } else {
      EXPECT_FALSE(stages.depth || stages.squared) << input.id;
    }
    EXPECT_FALSE(stages.left_out.empty()) << input.id;
  }
}

TEST(Shapes, HalfSpacesHaveNoOutline) {
  const Stages stages = stages_of(at(sphere(1), 0), files::body_of(halfspace({0, 0, 1}, 0)));
  EXPECT_TRUE(stages.b.sampled && stages.b.vertices.empty());
  EXPECT_TRUE(
      std::ranges::any_of(stages.left_out, [](const std::string& s) { return s.starts_with("B is a half-space"); }));
  EXPECT_EQ(stages.depth, 1.0);
  EXPECT_EQ(stages.contact.direction, (Place{0, 0, 1}));
}

}  // namespace
}  // namespace fathom::stages
