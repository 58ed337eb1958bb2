// SPDX-License-Identifier: GPL-3.0-or-later
// P round O: the circle's radius is the depth, it touches the nearest facet, hidden edges are those behind, and what is small gets a
// close-up.
#include "view/picture/sum_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/matches.hpp"

namespace fathom::picture {
namespace {

/// The box from -low to high, as a mesh.
Mesh box_mesh(const Point& low, const Point& high) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  mesh.polygons = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  mesh.normals = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  return mesh;
}

SumScene scene_of_box(const mpq_class& depth) {
  const Mesh mesh = box_mesh({-4, -4, -4}, {depth, 4, 4});
  const View view(Point{1, 0, 0}, std::nullopt);
  return {view, {wires_of(mesh, view)}, {{mesh.vertices[1], mesh.vertices[3], mesh.vertices[7], mesh.vertices[5]}}, {depth, 0, 0}};
}

TEST(SumScene, TheBallTouchesTheNearestFacet) {
  const std::string text = sum_panels(scene_of_box(2), "s", "P", "");
  const std::string ball = all(text, "(<ellipse class=\"ball\"[^>]*>)").at(0);
  const double x = std::stod(all(ball, "cx=\"([^\"]*)\"").at(0)), radius = std::stod(all(ball, "rx=\"([^\"]*)\"").at(0));
  EXPECT_NEAR(std::stod(all(ball, "ry=\"([^\"]*)\"").at(0)), radius, 0.11);
  const std::vector<std::string> near = all(all(text, "<path class=\"near\" d=\"([^\"]*)\"").at(0), "[ML](-?[0-9.]+)");
  ASSERT_GE(near.size(), 2u);
  for (const std::string& at : near) EXPECT_NEAR(std::stod(at), x + radius, 0.2) << "law: seen from its edge, where the ball ends";
  EXPECT_EQ(all(text, "<svg").size(), 1u);
}

TEST(SumScene, ASmallBallGetsACloseUp) {
  const std::string text = sum_panels(scene_of_box(mpq_class(1, 100)), "s", "P", "");
  EXPECT_EQ(all(text, "<svg").size(), 2u);
  const std::vector<std::string> radii = all(text, "rx=\"([^\"]*)\"");
  ASSERT_EQ(radii.size(), 2u);
  EXPECT_LT(std::stod(radii[0]), 1);
  EXPECT_EQ(radii[1], "80.0");
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(SumScene, ASpeckGetsNone) {
  const mpq_class tiny = mpq_class(1, 10'000'000) / 100'000;
  EXPECT_TRUE(is_speck(scene_of_box(tiny)));
  EXPECT_FALSE(is_speck(scene_of_box(mpq_class(1, 100))));
  EXPECT_EQ(all(sum_panels(scene_of_box(tiny), "s", "P", ""), "(<svg)").size(), 1u) << "law: no close-up that doubles could not draw";
}

TEST(SumScene, HiddenEdgesAreThoseBehind) {
  const Mesh mesh = box_mesh({-4, -4, -4}, {1, 4, 4});
  EXPECT_EQ(edges_count(mesh), 12u);
  const Wires wires = wires_of(mesh, View(Point{1, 0, 0}, std::nullopt));
  EXPECT_EQ(wires.wires.size(), 12u);
  EXPECT_EQ(std::ranges::count(wires.wires, true, &Wires::Wire::hidden), 1) << "two of the six faces are seen from their edge";
}

TEST(SumScene, AMeshShowsItsCreases) {
  Mesh mesh = box_mesh({-4, -4, -4}, {1, 4, 4});
  mesh.polygons.erase(mesh.polygons.begin());  // a side of two triangles in one plane
  mesh.normals.erase(mesh.normals.begin());
  mesh.polygons.insert(mesh.polygons.end(), {{0, 4, 6}, {0, 6, 2}});
  mesh.normals.insert(mesh.normals.end(), 2, {-1, 0, 0});
  const View view(Point{1, 0, 0}, std::nullopt);
  EXPECT_EQ(wires_of(mesh, view).wires.size(), 13u);
  mesh.creases = true;
  EXPECT_EQ(wires_of(mesh, view).wires.size(), 12u) << "law: the diagonal of a side is no edge of the body";
}

}  // namespace
}  // namespace fathom::picture
