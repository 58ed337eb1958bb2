// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes: the way out keeps its length and points to the right, faces in contact are seen from
// their edge, hidden edges are those behind, and every kind of body has an outline.
#include "view/picture/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/vector.hpp"
#include "tests/picture/picture_size.hpp"
#include "tests/support/boxes.hpp"

namespace fathom::picture {
namespace {

using testing::box;

struct Cubes {
  GivenPoints a = box({0, 0, 0}, {1, 1, 1}), b;
  Depth depth;

  explicit Cubes(const mpq_class& at)
      : b(box({at, 0, 0}, {mpq_class(at + 1), 1, 1})), depth(penetration_depth(a.exact(), b.exact())) {}
  [[nodiscard]] PairScene scene() const { return scene_of({a, b, depth}); }
};

/// Of a convex body.
std::vector<Dot> silhouette(const Drawn& body, const Window& window) {
  const std::vector<std::vector<Dot>> all = silhouettes(body, window);
  EXPECT_EQ(all.size(), 1u);
  return all.front();
}

Dot extent(const std::vector<Dot>& dots) {
  const auto [left, right] = std::ranges::minmax(dots, {}, &Dot::x);
  const auto [top, bottom] = std::ranges::minmax(dots, {}, &Dot::y);
  return {right.x - left.x, bottom.y - top.y};
}

TEST(Scene, TheWayIsTrueAndPointsRight) {
  const Cubes cubes(mpq_class(3, 4));  // A must go left by 1/4
  const PairScene scene = cubes.scene();
  EXPECT_EQ(scene.status, Status::penetrating);
  const Panel whole = panels_of(scene, size).front();
  const Dot from = whole.window.dot(scene.anchor), to = whole.window.dot(scene.anchor + scene.way);
  EXPECT_NEAR(to.x - from.x, whole.window.scale().x.get_d() / 4, 1e-9);
  EXPECT_NEAR(to.y, from.y, 1e-9);
  EXPECT_GT(to.x, from.x);
}

TEST(Scene, FacesInContactAreSeenFromTheirEdge) {
  const Cubes cubes(mpq_class(3, 4));
  const PairScene scene = cubes.scene();
  ASSERT_EQ(scene.touch_a.size(), 1u);
  ASSERT_EQ(scene.touch_b.size(), 1u);
  const Window window = panels_of(scene, size).front().window;
  for (const auto* face : {&scene.touch_a, &scene.touch_b}) {
    ASSERT_EQ(face->front().size(), 4u);
    const Dot seen = extent(window.hull(face->front()));
    EXPECT_NEAR(seen.x, 0, 1e-9);
    EXPECT_GT(seen.y, 20);
  }
}

TEST(Scene, HiddenEdgesAreBehind) {
  const Cubes cubes(mpq_class(1, 2));
  const auto scene = cubes.scene();
  const auto& wires = std::get<Wires>(scene.a).wires;
  EXPECT_EQ(wires.size(), 12u);
  EXPECT_EQ(std::ranges::count(wires, true, &Wires::Wire::hidden), 1)
      << "two of the six faces are seen from their edge";
  const GivenPoints flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const Wires::Wire& wire : wires_of(flat, View(Point{1, 0, 0}, std::nullopt)).wires) EXPECT_FALSE(wire.hidden);
}

TEST(Scene, LargeBodiesKeepWhatIsSeen) {
  std::vector<Point> points;
  for (int i = 0; i < 120; ++i) {  // a prism of 120 sides: 360 edges
    mpq_class t(i - 60, 60);
    t.canonicalize();
    const mpq_class square = t * t;
    const mpq_class x = (1 - square) / (1 + square), y = 2 * t / (1 + square);
    for (const int z : {0, 1}) points.push_back({i % 2 ? x : mpq_class(-x), i % 2 ? y : mpq_class(-y), z});
  }
  const View view(Point{0, 0, 1}, std::nullopt);
  const Wires some = wires_of(points, view);
  EXPECT_GT(some.wires.size(), 150u);
  EXPECT_TRUE(std::ranges::none_of(some.wires, &Wires::Wire::hidden)) << "over 200 edges";
  const std::size_t once = points.size();
  for (std::size_t i = 0; i < once; ++i)
    points.push_back(mpq_class(101, 100) * points[i] + Point{0, 0, mpq_class(static_cast<long>(i % 2) * 3)});
  EXPECT_LT(wires_of(points, view).wires.size(), 400u);
}

TEST(Scene, TouchingAndDisjoint) {
  const PairScene touching = Cubes(1).scene();
  EXPECT_FALSE(touching.moves());
  EXPECT_EQ(panels_of(touching, size).size(), 1u);
  const PairScene apart = Cubes(3).scene();
  EXPECT_EQ(apart.status, Status::disjoint);
  EXPECT_EQ(apart.way, (Point{2, 0, 0}));
  const Window window = panels_of(apart, size).front().window;
  EXPECT_LT(window.dot(apart.anchor).x, window.dot(apart.anchor + apart.way).x);
}

// Of bounds around 0 the way is their middle: nobody knows that the bodies touch.
TEST(Scene, SaysWhatTheDotIsByTheStatus) {
  PairScene scene = Cubes(1).scene();
  EXPECT_EQ(scene.dot_text(), "where they touch");
  EXPECT_NE(description_of(scene).find("the dot is where they touch."), std::string::npos);
  scene.status = Status::disjoint;
  EXPECT_EQ(scene.dot_text().find("where they are nearest"), 0U);
  for (const std::optional<Status> status : {std::optional(Status::penetrating), std::optional<Status>()}) {
    scene.status = status;
    EXPECT_EQ(scene.dot_text().find("where they would touch"), 0U);
  }
}

TEST(Scene, CloseUpsOfShortWays) {
  const PairScene scene = Cubes(mpq_class(999, 1000)).scene();
  const std::vector<Panel> panels = panels_of(scene, size);
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_TRUE(panels[1].close);
  EXPECT_NEAR(panels[1].window.dot(scene.anchor + scene.way).x - panels[1].window.dot(scene.anchor).x, 70, 1e-9);
  EXPECT_GE(silhouette(scene.a, panels[1].window).size(), 3u) << "a wall";
}

// ---- shapes ----

PairScene of_shapes(const Shape& a, const Shape& b) { return scene_of(a, b, signed_depth(a, b)); }

Shape at(const Shape& shape, const Point& place) {
  return moved(shape, {{{1, 0, 0, place.x}, {0, 1, 0, place.y}, {0, 0, 1, place.z}}});
}

TEST(Scene, SpheresAreRound) {
  const PairScene scene = of_shapes(sphere(2), at(sphere(1), {mpq_class(5, 2), 0, 0}));
  EXPECT_TRUE(scene.approximate());
  const Window window = panels_of(scene, size).front().window;
  const std::vector<Dot> around = silhouette(scene.a, window);
  const Dot middle = window.dot({0, 0, 0});
  const double radius = 2 * window.scale().x.get_d();
  EXPECT_GT(around.size(), 60u);
  for (const Dot& d : around) EXPECT_NEAR(std::hypot(d.x - middle.x, d.y - middle.y), radius, 0.05);
  EXPECT_NEAR(window.dot(scene.anchor + scene.way).x - window.dot(scene.anchor).x, window.scale().x.get_d() / 2, 1e-6)
      << "depth 1/2";
}

TEST(Scene, OutlinesOfShapes) {
  const View view(Point{1, 0, 0}, Point{0, 0, 1});  // x to the right, z up
  const Window window = Window::around(view, {{-4, -4}, {4, 4}}, size);
  const double unit = window.scale().x.get_d();
  const auto seen = [&](const Shape& shape) {
    const Dot pixels = extent(silhouette(drawn_shape(shape, view), window));
    return std::pair(pixels.x / unit, pixels.y / unit);
  };
  const auto expect = [&](const Shape& shape, double width, double height, const char* what) {
    const auto [x, y] = seen(shape);
    EXPECT_NEAR(x, width, 0.01) << what;
    EXPECT_NEAR(y, height, 0.01) << what;
    const Bounds2 box = *box_of(drawn_shape(shape, view), view);
    EXPECT_NEAR(box.width().get_d(), width, 1e-9) << what;
    EXPECT_NEAR(box.height().get_d(), height, 1e-9) << what;
  };
  expect(fathom::box({1, 2, 3}), 2, 6, "a box");
  expect(capsule(1, 2), 2, 6, "a capsule");
  expect(cylinder(1, 2), 2, 4, "a cylinder");
  expect(cone(2, 1), 4, 2, "a cone");
  expect(ellipsoid({3, 1, 2}), 6, 4, "an ellipsoid");
  expect(with_margin(fathom::box({1, 1, 1}), mpq_class(1, 2)), 3, 3, "a margin");
  expect(minkowski_sum(cylinder(1, 1), at(sphere(1), {0, 0, 1})), 4, 4, "a sum");
  EXPECT_TRUE(std::holds_alternative<Wires>(drawn_shape(fathom::box({1, 1, 1}), view)));
}

TEST(Scene, HalfSpacesEndAtTheirPlane) {
  const Shape floor = halfspace({0, 0, 1}, 1);
  for (const bool first : {true, false}) {
    const Shape ball = at(sphere(1), {0, 0, mpq_class(3, 2)});
    const PairScene scene = first ? of_shapes(floor, ball) : of_shapes(ball, floor);
    const Window window = panels_of(scene, size).front().window;
    const std::vector<Dot> half = silhouette(first ? scene.a : scene.b, window);
    ASSERT_EQ(half.size(), 4u);
    const double plane = window.dot({0, 0, 1}).x;
    const auto [left, right] = std::ranges::minmax(half, {}, &Dot::x);
    EXPECT_NEAR(first ? left.x : right.x, plane, 1e-6);
    EXPECT_TRUE(first ? right.x > 400 : left.x < 0) << "the rest is beyond the window";
    EXPECT_NEAR(window.dot(scene.anchor + scene.way).x - window.dot(scene.anchor).x, window.scale().x.get_d() / 2,
                1e-6);
  }
}

// A cylinder and a cone: the answer is enclosed, and its way is drawn by its bounds.
TEST(Scene, EnclosedWays) {
  const PairScene scene = of_shapes(cylinder(1, 2), at(cone(1, 1), {mpq_class(6, 5), mpq_class(3, 10), 1}));
  EXPECT_TRUE(scene.enclosed);
  EXPECT_TRUE(scene.approximate());
  EXPECT_NEAR(std::sqrt(dot(scene.way, scene.way).get_d()), 0.763068312312, 1e-9);
  EXPECT_NEAR(std::hypot(scene.anchor.x.get_d(), scene.anchor.y.get_d()), 1, 1e-9) << "on the side of the cylinder";
}

// Cylinders that touch along their axes: the value of curved bodies may be known too, though no
// translation is.
TEST(Scene, KnownValuesOfCurvedBodies) {
  const Shape a = cylinder(1, 1), b = at(cylinder(1, 1), {0, 0, 2});
  const SignedDepth depth = signed_depth(a, b);
  ASSERT_TRUE(depth.exact() && depth.translations().empty()) << "else the case has to be another";
  EXPECT_FALSE(scene_of(a, b, depth).enclosed);
  EXPECT_FALSE(scene_of(a, b, depth).moves());
}

// ---- the plane ----

TEST(Scene, ThePlaneIsSeenFromAbove) {
  const Shape square = hull(std::vector<Point>{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}});
  const Shape below = halfspace({1, 2, 0}, 3);
  SignedDepth depth = signed_depth(square, below);
  const PairScene scene = scene_of(square, below, depth, std::nullopt, true);
  const Window window = panels_of(scene, size).front().window;
  const Dot o = window.dot({}), x = window.dot({1, 0, 0}), y = window.dot({0, 1, 0}), z = window.dot({0, 0, 1});
  EXPECT_GT(x.x, o.x);
  EXPECT_EQ(x.y, o.y);
  EXPECT_EQ(y.x, o.x);
  EXPECT_LT(y.y, o.y);  // pixels count downwards
  EXPECT_NEAR(z.x, o.x, 1e-9);
  EXPECT_NEAR(z.y, o.y, 1e-9);
  EXPECT_EQ(silhouette(scene.a, window).size(), 4u);
  // A half-plane is a polygon of the window on the side of its normal where it is.
  const Dot inside = window.dot({0, 0, 0}), outside = window.dot({3, 3, 0});
  const std::vector<Dot> half = silhouette(scene.b, window);
  ASSERT_GE(half.size(), 3u);
  const auto holds = [&](const Dot& p) {
    int signs = 0;
    for (std::size_t i = 0; i < half.size(); ++i) {
      const Dot &q = half[i], &r = half[(i + 1) % half.size()];
      signs += (r.x - q.x) * (p.y - q.y) - (r.y - q.y) * (p.x - q.x) > 0 ? 1 : -1;
    }
    return static_cast<std::size_t>(std::abs(signs)) == half.size();
  };
  EXPECT_TRUE(holds(inside));
  EXPECT_FALSE(holds(outside));
}

}  // namespace
}  // namespace fathom::picture
