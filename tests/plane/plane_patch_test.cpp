// SPDX-License-Identifier: GPL-3.0-or-later
// Where bodies of the plane touch, and how their signed depth changes: patches by the definition,
// rates as those of thick prisms in space, and closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "fathom/patch.hpp"
#include "reference/patch/patch.hpp"
#include "tests/plane/pairs.hpp"

namespace fathom::plane {
namespace {

Body rounded(const Points& points, const mpq_class& radius) {
  Body body;
  body.shape = Shape{fathom::hull(points).core, radius};
  return in_plane(std::move(body));
}

Body half_plane(const Point& normal, const mpq_class& offset) {
  Body body;
  body.shape = halfspace(normal, offset);
  return in_plane(std::move(body));
}

Body union_of(const std::vector<Points>& pieces, long half = 0) {
  Body body;
  Pieces all;
  for (const Points& piece : pieces) all.push_back(half > 0 ? prism(piece, half) : piece);
  body.pieces = std::make_shared<const Pieces>(std::move(all));
  return half > 0 ? body : in_plane(std::move(body));
}

ContactGeometry geometry_of(const Body& a, const Body& b) { return contact_geometry(a, b, exact_answer(a, b)); }

Twist planar(const mpq_class& x, const mpq_class& y, const mpq_class& w) { return {{x, y, 0}, {0, 0, w}}; }

Surd rate(const ContactGeometry& geometry, const Twist& of_a, const Twist& of_b = {}) {
  return std::get<DirectionalDerivative>(directional_derivative(geometry, of_a, of_b)).value();
}

std::string exactly(const Surd& value) { return value.rational.get_str() + " " + value.root.get_str(); }

// ---- the definition: what two faces on one line share ----

struct NaiveCorner {
  Point b;
  std::vector<std::uint32_t> on_a, on_b;
  auto operator<=>(const NaiveCorner& other) const {
    return std::pair(on_a, on_b) <=> std::pair(other.on_a, other.on_b);
  }
  bool operator==(const NaiveCorner&) const = default;
};

/// The end of what the faces share that is farthest along the line, or least far.
NaiveCorner end_of(const Points& a, const std::vector<std::uint32_t>& of_a, const Points& b,
                   const std::vector<std::uint32_t>& of_b, const Point& along) {
  const auto farthest = [&](const Points& points, const std::vector<std::uint32_t>& face) {
    return *std::ranges::max_element(
        face, [&](std::uint32_t i, std::uint32_t j) { return height(along, points[i]) < height(along, points[j]); });
  };
  const std::uint32_t i = farthest(a, of_a), j = farthest(b, of_b);
  const mpq_class at_a = height(along, a[i]), at_b = height(along, b[j]);
  NaiveCorner corner{at_a < at_b ? a[i] : b[j], {i}, {j}};
  if (at_a < at_b) corner.on_b = of_b;
  if (at_b < at_a) corner.on_a = of_a;
  return corner;
}

/// The corners of the patch in direction n, after A has been moved by t.
std::vector<NaiveCorner> naive_patch(const Points& a, const Points& b, const Vector& n, const Point& t) {
  const Point u = rational(n), along{-u.y, u.x, 0};
  const Points there = moved(a, t);
  const std::vector<std::uint32_t> of_a = naive_face(a, -u), of_b = naive_face(b, u);
  std::vector<NaiveCorner> corners{end_of(there, of_a, b, of_b, along), end_of(there, of_a, b, of_b, -along)};
  if (corners[0].b == corners[1].b) corners.pop_back();
  std::ranges::sort(corners);
  return corners;
}

TEST(PlanePatch, IsWhatTheFacesShare) {
  Random random(21);
  std::size_t segments = 0, points = 0, told = 0;
  for (const PairKind kind : all_kinds)
    for (int i = 0; i < 60; ++i) {
      const PlanePair pair = plane_pair(kind, random);
      const ContactGeometry geometry = geometry_of(body_of(pair.a), body_of(pair.b));
      EXPECT_EQ(geometry.dimension, 2U);
      ASSERT_FALSE(geometry.patches.empty());
      for (const Patch& patch : geometry.patches) {
        const Point t = patch.translation();
        EXPECT_TRUE(t.z == 0 && patch.direction.z == 0);
        std::vector<NaiveCorner> corners;
        for (std::size_t k = 0; k < patch.corners.size(); ++k) {
          EXPECT_EQ(patch.b(k).core, patch.a(k).core + t);
          corners.push_back({patch.b(k).core, patch.corners[k].on_a, patch.corners[k].on_b});
        }
        const std::vector<NaiveCorner> naive = naive_patch(pair.a, pair.b, patch.direction, t);
        ASSERT_EQ(corners.size(), naive.size()) << text_of(pair);
        if (naive.size() == 1) {
          EXPECT_EQ(corners[0].b, naive[0].b) << text_of(pair);
        } else {
          EXPECT_TRUE(corners == naive) << text_of(pair);
        }
        const Point length = naive.back().b - naive.front().b;
        EXPECT_EQ(patch.squared(), square(length));
        ++(naive.size() == 2 ? segments : points);
      }
      const bool extended = std::ranges::any_of(geometry.patches, [](const Patch& patch) { return patch.rank() > 0; });
      EXPECT_EQ(std::ranges::count(geometry.kinks, Kink::extended), extended ? 1 : 0);
      if (geometry.smooth()) {
        ++told;
        EXPECT_EQ(geometry.gradient()->point.z, 0);
      }
    }
  EXPECT_GT(segments, 30U);
  EXPECT_GT(points, 100U);
  EXPECT_GT(told, 30U);
}

// A twist of the plane moves prisms as it moves what they stand on.
TEST(PlanePatch, RatesAreThoseOfThickPrisms) {
  Random random(22);
  const auto number = [&] { return mpq_class(random.between(-5, 5)); };
  for (const PairKind kind : all_kinds)
    for (int i = 0; i < 40; ++i) {
      const PlanePair pair = plane_pair(kind, random);
      const ContactGeometry plane = geometry_of(body_of(pair.a), body_of(pair.b)),
                            space = geometry_of(Body{prism(pair.a, 3000)}, Body{prism(pair.b, 4999)});
      EXPECT_EQ(plane.cone.has_value(), space.cone.has_value());
      for (int k = 0; k < 3; ++k) {
        const Twist of_a = planar(number(), number(), number()), of_b = planar(number(), number(), number());
        EXPECT_EQ(exactly(rate(plane, of_a, of_b)), exactly(rate(space, of_a, of_b))) << text_of(pair);
        EXPECT_EQ(std::get<DirectionalDerivative>(directional_derivative(plane, of_a, of_b)).direction.z, 0);
      }
      EXPECT_EQ(exactly(rate(plane, {})), "0 0");
    }
}

TEST(PlanePatch, RatesOfUnionsAreThoseOfPrisms) {
  Random random(23);
  std::size_t told = 0;
  for (int i = 0; i < 30; ++i) {
    std::vector<Points> a, b;
    for (std::vector<Points>* pieces : {&a, &b})
      while (pieces->size() < 2) {
        Points piece = random_points(random, 4, 8);
        if (hull(piece).size() > 2) pieces->push_back(std::move(piece));
      }
    if (i % 3 == 0)
      for (Points& piece : b) piece = moved(std::move(piece), {30, random.between(-4, 4), 0});
    const ContactGeometry plane = geometry_of(union_of(a), union_of(b)),
                          space = geometry_of(union_of(a, 100), union_of(b, 333));
    EXPECT_EQ(plane.clearance, space.clearance);
    for (const Patch& patch : plane.patches) {
      EXPECT_LT(patch.rank(), 2);
      for (std::size_t k = 0; k < patch.corners.size(); ++k) EXPECT_EQ(patch.b(k).core.z, 0);
    }
    const Twist of_a = planar(1, random.between(-3, 3), random.between(-2, 2)), of_b = planar(0, 1, 1);
    const auto here = directional_derivative(plane, of_a, of_b), there = directional_derivative(space, of_a, of_b);
    ASSERT_EQ(here.index(), there.index());
    if (const auto* const found = std::get_if<DirectionalDerivative>(&here)) {
      EXPECT_EQ(exactly(found->value()), exactly(std::get<DirectionalDerivative>(there).value()));
      ++told;
    } else {
      EXPECT_EQ(std::get<LeftOut>(here), std::get<LeftOut>(there));
    }
  }
  EXPECT_GT(told, 15U);
}

TEST(PlanePatch, ClosedForms) {
  // Circles (3, 4) apart: the distance shrinks by 3/5 a unit along x, not by turns about a centre.
  const ContactGeometry circles = geometry_of(rounded({{0, 0, 0}}, 1), rounded({{3, 4, 0}}, 1));
  EXPECT_EQ(exactly(rate(circles, planar(1, 0, 7))), "0 9/25");
  EXPECT_EQ(exactly(rate(circles, {}, planar(0, 0, 1))), "0 0");
  EXPECT_EQ(circles.patches.at(0).rank(), 0);
  // Concentric ones: whatever way they part, they do so at the whole speed.
  const ContactGeometry same = geometry_of(rounded({{0, 0, 0}}, 1), rounded({{0, 0, 0}}, 2));
  EXPECT_EQ(same.cone->lineality, Lineality::all);
  EXPECT_EQ(exactly(rate(same, planar(3, 4, 1))), "0 -25");
  EXPECT_EQ(exactly(rate(same, planar(0, 0, 1))), "0 0");
  // A segment from (0, 1) to (2, 1) above the half-plane y <= 0: its lowest point counts.
  const ContactGeometry above = geometry_of(body_of({{0, 1, 0}, {2, 1, 0}}), half_plane({0, 1, 0}, 0));
  EXPECT_EQ(above.patches.at(0).rank(), 1);
  EXPECT_EQ(above.patches.at(0).squared(), 4);
  EXPECT_EQ(exactly(rate(above, planar(5, 0, 1))), "0 0");
  EXPECT_EQ(exactly(rate(above, planar(5, 0, -1))), "0 4");
  EXPECT_EQ(above.kinks, std::vector{Kink::extended});
  // A corner in an edge: smooth, with the rate -<n, v + w x p>.
  const Points corner{{0, -1, 0}, {3, 3, 0}, {-3, 3, 0}}, floor{{-9, 0, 0}, {9, 0, 0}, {9, -9, 0}, {-9, -9, 0}};
  const ContactGeometry smooth = geometry_of(body_of(corner), body_of(floor));
  ASSERT_TRUE(smooth.smooth());
  EXPECT_EQ(smooth.gradient()->normal, (Vector{0, 1, 0}));
  EXPECT_EQ(smooth.gradient()->point, (Point{0, -1, 0}));
  EXPECT_EQ(exactly(rate(smooth, planar(0, 2, 9))), "0 -4");
  EXPECT_EQ(vertex_weights(body_of(corner), body_of(floor), smooth)->a, (std::vector<Weight>{{0, 1}}));
  // With a slack of 1/2 as far as the sides, of the slope 4/3, are that high above it.
  const auto reach = patch::with_slack(body_of(corner), body_of(floor), smooth.patches[0], mpq_class(1, 2));
  ASSERT_TRUE(reach);
  ASSERT_EQ(reach->size(), 2U);
  std::vector<mpq_class> ends{reach->at(0).a.core.x, reach->at(1).a.core.x};
  std::ranges::sort(ends);
  EXPECT_EQ(ends, (std::vector{mpq_class(-3, 8), mpq_class(3, 8)}));
}

TEST(PlanePatch, OfUnionsInASlotAndApart) {
  const auto square = [](const mpq_class& x, const mpq_class& y) {
    return Points{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}};
  };
  const Body slot = union_of({square(-1, 0), square(1, 0)});
  const ContactGeometry held = geometry_of(union_of({square(mpq_class(-1, 4), 0)}), slot);
  EXPECT_EQ(held.patches.size(), 2U);
  for (const Patch& patch : held.patches) EXPECT_TRUE(patch.one_plane && patch.squared() == 1);
  EXPECT_EQ(exactly(rate(held, planar(-3, 0, 0))), "0 9");
  EXPECT_EQ(std::get<LeftOut>(directional_derivative(held, planar(0, 0, 1))), LeftOut::exact_fit);
  const Points diamond{{0, 0, 0}, {1, 1, 0}, {0, 2, 0}, {-1, 1, 0}};
  const ContactGeometry apart = geometry_of(union_of({diamond}), union_of({moved(diamond, {0, 5, 0})}));
  EXPECT_EQ(apart.patches.at(0).rank(), 0);
  EXPECT_EQ(exactly(rate(apart, planar(0, 1, 0))), "0 1");
}

TEST(PlanePatch, WhatIsRefused) {
  const Body point = body_of({{0, 0, 0}}), other = body_of({{1, 0, 0}});
  const Answer answer = exact_answer(point, other);
  EXPECT_THROW(contact_geometry(Body{{{0, 0, 0}}}, Body{{{1, 0, 0}}}, answer), std::invalid_argument);
  EXPECT_THROW(contact_geometry(point, other, exact_answer(Body{{{0, 0, 0}}}, Body{{{1, 0, 0}}})),
               std::invalid_argument);
  const ContactGeometry geometry = contact_geometry(point, other, answer);
  for (const Twist& twist : {Twist{{0, 0, 1}, {}}, Twist{{}, {1, 0, 0}}, Twist{{}, {0, 1, 0}}}) {
    EXPECT_THROW(directional_derivative(geometry, twist), std::invalid_argument);
    EXPECT_THROW(directional_derivative(geometry, {}, twist), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fathom::plane
