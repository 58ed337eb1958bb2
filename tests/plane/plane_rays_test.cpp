// SPDX-License-Identifier: GPL-3.0-or-later
// What rays answer in the plane, against naive twins over the edges of B - A: depths in a direction
// and in a norm, growth distances, depths and widths within a factor; and exact widths.
#include "tests/plane/plane_rays.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <variant>

namespace fathom::plane {
namespace {

TEST(PlaneRays, EqualTheNaiveTwins) { expect_right_rays(60); }

// ---- closed forms ----

Body square() { return body_of({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}); }
Body triangle() { return body_of({{1, 1, 0}, {4, 1, 0}, {1, 5, 0}}); }

TEST(PlaneRays, HaveTheirClosedForms) {
  const DirectionalDepth ray = directional_depth(square(), triangle(), {-2, 0, 0});
  EXPECT_EQ(ray.factor(), mpq_class(1, 2));
  EXPECT_EQ(ray.penetration()->contact.kind, ContactKind::edge_edge);
  EXPECT_EQ(ray.penetration()->contact.a, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(ray.penetration()->contact.b, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(directional_depth(square(), body_of({{2, 1, 0}, {3, 1, 0}}), {0, 1, 0}).normal(), (Vector{-1, 0, 0}));

  // Squares of half lengths 1 whose centres are (3, 1) apart touch when these are 3/2.
  const Body there = body_of({{3, 1, 0}, {5, 1, 0}, {5, 3, 0}, {3, 3, 0}});
  const GrowthDistance growth = growth_distance(square(), there);
  EXPECT_EQ(growth.growth, mpq_class(3, 2));
  EXPECT_EQ(growth.center_b, (Point{4, 2, 0}));
  EXPECT_EQ(growth_distance(square(), square()).growth, 0);
  EXPECT_EQ(growth_distance(square(), there, Point{1, 1, 0}, Point{3, 1, 0}).growth, 2);

  // In the norm of the maximum, and in that of the sum, of the coordinates.
  const Body max_ball = body_of({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
  const UnitBall max = unit_ball(max_ball);
  EXPECT_TRUE(max.symmetric);
  EXPECT_EQ(max.vertices.size(), 4U);
  EXPECT_EQ(metric_depth(square(), triangle(), max).depth(), 1);
  const UnitBall gauge = unit_ball(body_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {-1, -1, 0}}));
  EXPECT_FALSE(gauge.symmetric);
  EXPECT_EQ(metric_depth(square(), triangle(), gauge).depth(), 1);
  EXPECT_EQ(metric_depth(square(), triangle(), gauge).optima().front().vertex, 3U);

  for (const mpq_class& delta : {mpq_class(1, 100), mpq_class(1), mpq_class(1000000)}) {
    const ApproxDepth found = approx_width(triangle(), delta);  // the height over the hypotenuse: 12/5
    EXPECT_LE(found.bound_squared(), mpq_class(144, 25));
    EXPECT_GE(found.squared(), mpq_class(144, 25));
    EXPECT_EQ(found.direction().z, 0) << "never along the prism";
    EXPECT_EQ(found.extreme_a, 3U);
  }
  EXPECT_EQ(std::get<Depth>(exact_answer(triangle(), triangle()).found).squared(), mpq_class(144, 25));
}

TEST(PlaneRays, WidthsOfRoundedPolygonsAreThoseOfTheirCoresAndTwiceTheirRadii) {
  const auto width_of = [](const Points& core, const mpq_class& radius) {
    Body body;
    body.shape = Shape{fathom::hull(core).core, radius};
    const Body rounded = in_plane(std::move(body));
    return *exact_answer(rounded, rounded).exact();
  };
  EXPECT_EQ(compare(width_of({{1, 2, 0}}, 3), Surd{6, 0}), 0) << "a circle";
  EXPECT_EQ(compare(width_of({{0, 0, 0}, {5, 1, 0}}, mpq_class(1, 2)), Surd{1, 0}), 0) << "a capsule";
  EXPECT_EQ(compare(width_of({{1, 1, 0}, {4, 1, 0}, {1, 5, 0}}, 1), Surd{2 + mpq_class(12, 5), 0}), 0);
}

// ---- refusals ----

TEST(PlaneRays, RefuseWhatIsNotInThePlane) {
  const Body space{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Body round;
  round.shape = sphere(1);
  const Body circle = in_plane(round);
  const UnitBall ball = unit_ball(body_of({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}));
  EXPECT_THROW(directional_depth(square(), space, {1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(directional_depth(square(), triangle(), {1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(directional_depth(square(), triangle(), {0, 0, 0}), std::invalid_argument);
  EXPECT_THROW(directional_depth(square(), circle, {1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(growth_distance(square(), triangle(), Point{0, 0, 1}), std::invalid_argument);
  EXPECT_THROW(growth_distance(square(), triangle(), Point{0, 0, 0}, Point{99, 0, 0}), NoGrowth);
  EXPECT_THROW(metric_depth(space, space, ball), std::invalid_argument);
  EXPECT_THROW(metric_depth(square(), space, ball), std::invalid_argument);
  EXPECT_THROW(metric_depth(square(), square(), unit_ball(Body{{{1, 1, 1}, {-1, 1, 1}, {0, -1, 1}, {0, 0, -1}}})),
               std::invalid_argument);
  EXPECT_THROW(approx_depth(square(), triangle(), 0), std::invalid_argument);
  EXPECT_THROW(approx_width(circle, 1), std::invalid_argument);
  EXPECT_THROW(unit_ball(circle), std::invalid_argument);
  const auto fault = [](const Points& points) -> std::string {
    try {
      return unit_ball(body_of(points)).symmetric ? "norm" : "gauge";
    } catch (const NoUnitBall& error) {
      return error.what();
    }
  };
  EXPECT_EQ(fault({{-1, 0, 0}, {1, 0, 0}}), "the unit ball is flat: its points lie on one line");
  EXPECT_EQ(fault({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "the unit ball has O on its boundary, which must lie inside it");
  EXPECT_EQ(fault({{1, 1, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}}),
            "the unit ball does not contain O, which must lie inside it");
}

}  // namespace
}  // namespace fathom::plane
