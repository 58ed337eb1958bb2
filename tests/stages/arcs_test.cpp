// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs end at their nodes, stay in their hemisphere, and are drawn as smooth lines; lines of a
// projection keep to the arc.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verify/families/families.hpp"
#include "view/stages/charts_picture.hpp"

namespace fathom::stages {
namespace {

using std::numbers::pi;

constexpr double near = 1e-9;

Stages staged(std::string_view family, unsigned size = 12) {
  const Case pair = families::find_family(family)->make(3, size);
  return stages::stages_of(pair.a, pair.b);
}

double distance(const Place& p, const Place& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

TEST(Arcs, EndAtTheirNodes) {
  for (const char* family : {"random_sphere", "boxes_aligned", "crossed_fans"}) {
    const Stages all = staged(family);
    for (const stages::StagedBody* body : {&all.a, &all.b})
      for (Index edge = 0; edge < body->arcs.size(); ++edge) {
        const std::optional<SphereArc> arc = arc_of(*body, edge);
        ASSERT_TRUE(arc);
        EXPECT_LT(distance(arc->at(arc->begin), body->nodes[*body->arcs[edge][0]]), near);
        EXPECT_LT(distance(arc->at(arc->end), body->nodes[*body->arcs[edge][1]]), near);
        EXPECT_LT(arc->end, pi) << "law: the shorter of the two";
      }
  }
}

TEST(Arcs, OfFlatBodiesGoRound) {
  const Stages flat = staged("polygon_segment");
  bool half = false, full = false;
  for (const stages::StagedBody* body : {&flat.a, &flat.b})
    for (Index edge = 0; edge < body->arcs.size(); ++edge) {
      const std::optional<SphereArc> arc = arc_of(*body, edge);
      ASSERT_TRUE(arc);
      (body->rank == 2 ? half : full) = true;
      EXPECT_NEAR(arc->end - arc->begin, body->rank == 2 ? pi : 2 * pi, near);
      for (double t = arc->begin; t <= arc->end; t += 0.1) {
        EXPECT_NEAR(dot(arc->at(t), body->circles[edge]), 0, near) << "law: on its circle";
        EXPECT_NEAR(dot(arc->at(t), arc->at(t)), 1, near);
      }
    }
  EXPECT_TRUE(half && full);
}

TEST(Arcs, PartsLieInTheirHemisphere) {
  const Stages all = staged("random_sphere", 40);
  for (const stages::StagedChart& chart : all.charts) {
    const Place other{-chart.z[0], -chart.z[1], -chart.z[2]};
    for (Index edge = 0; edge < all.a.arcs.size(); ++edge) {
      const SphereArc arc = *arc_of(all.a, edge);
      double length = 0;
      for (const Place& z : {chart.z, other})
        for (const SphereArc& part : parts_in(arc, z)) {
          length += part.end - part.begin;
          for (double share = 0; share <= 1; share += 0.25)
            EXPECT_GE(dot(part.at(part.begin + share * (part.end - part.begin)), z), -near);
        }
      EXPECT_NEAR(length, arc.end - arc.begin, 1e-7) << "law: both hemispheres together hold the arc";
    }
  }
}

TEST(Arcs, LinesKeepToTheArc) {
  const SphereArc arc{{1, 0, 0}, {0, 1, 0}, 0, 3};
  const auto project = [](const Place& p) { return Pixel{300 * p[0], 300 * p[1]}; };
  const std::vector<Pixel> line = polyline(arc, project);
  EXPECT_LT(line.size(), 200u);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double x = (line[i - 1].x + line[i].x) / 2, y = (line[i - 1].y + line[i].y) / 2;
    EXPECT_NEAR(std::hypot(x, y), 300, 0.5) << "law: off by less than half a pixel";
  }
  EXPECT_NEAR(line.front().x, 300, near);
  EXPECT_NEAR(line.back().x, 300 * std::cos(3), near);
}

}  // namespace
}  // namespace fathom::stages
