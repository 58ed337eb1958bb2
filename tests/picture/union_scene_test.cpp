// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of unions: the way out points to the right, planes between pieces are seen from their
// edges, the outline is that of all pieces together, and those in contact are marked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "kernels/vector.hpp"
#include "tests/picture/picture_size.hpp"
#include "tests/support/boxes.hpp"
#include "tests/support/matches.hpp"
#include "view/picture/scene.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {
namespace {

using testing::box;

/// An L of two bars, and a peg in its corner.
struct Corner {
  Pieces a{box({0, 0, 0}, {1, 1, 1})};
  Pieces b{box({mpq_class(1, 2), -3, -3}, {1, 4, 4}), box({-3, mpq_class(3, 4), -3}, {1, 1, 4})};
  UnionDepth depth = union_depth(a, b);
};

TEST(UnionScene, TheWayPointsRightAndPlanesAreSeenFromTheirEdges) {
  const Corner corner;
  ASSERT_EQ(corner.depth.status, Status::penetrating);
  const PairScene scene = scene_of(corner.a, corner.b, corner.depth);
  EXPECT_TRUE(scene.of_unions());
  EXPECT_EQ(scene.way, corner.depth.optima.front().translation);
  ASSERT_EQ(scene.touch_a.size(), corner.depth.optima.front().contacts.size());
  ASSERT_EQ(scene.touch_a.size(), 2u) << "else the case has to be another";
  const Window window = panels_of(scene, size).front().window;
  const Dot from = window.dot(scene.anchor), to = window.dot(scene.anchor + scene.way);
  EXPECT_GT(to.x, from.x);
  EXPECT_NEAR(to.y, from.y, 1e-9);
  for (const auto* faces : {&scene.touch_a, &scene.touch_b})
    for (const std::vector<Point>& face : *faces) {
      const std::vector<Dot> seen = window.hull(face);
      EXPECT_LE(seen.size(), 4u);
      double area = 0;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        const Dot &p = seen[i], &q = seen[(i + 1) % seen.size()];
        area += (p.x * q.y - p.y * q.x) / 2;
      }
      EXPECT_NEAR(area, 0, 1e-6) << "law: a face in contact is a line";
    }
}

/// Whether the place lies in one of the convex pieces, which are boxes.
bool is_in(const Pieces& pieces, const Point& p) {
  return std::ranges::any_of(pieces, [&](const std::vector<Point>& box) {
    return box.front().x <= p.x && p.x <= box.back().x && box.front().y <= p.y && p.y <= box.back().y &&
           box.front().z <= p.z && p.z <= box.back().z;
  });
}

TEST(UnionScene, TheWayBeginsInAAndEndsInB) {
  const Corner corner;
  const PairScene scene = scene_of(corner.a, corner.b, corner.depth);
  EXPECT_TRUE(is_in(corner.a, scene.anchor));
  EXPECT_TRUE(is_in(corner.b, scene.anchor + scene.way)) << "law: the way ends where the bodies touch";
}

TEST(UnionScene, PiecesInContactAreMarked) {
  const Corner corner;
  const PairScene scene = scene_of(corner.a, corner.b, corner.depth);
  EXPECT_EQ(std::get<Compound>(scene.b).in_contact, (std::vector<bool>{true, true}));
  Pieces more = corner.b;
  more.push_back(box({50, 50, 50}, {51, 51, 51}));
  const PairScene third = scene_of(corner.a, more, union_depth(corner.a, more));
  EXPECT_EQ(std::get<Compound>(third.b).in_contact, (std::vector<bool>{true, true, false}));
  const std::string text = painted(third, panels_of(third, size).front(), "x");
  EXPECT_EQ(all(text, "class=\"(body-b in-contact toned)\"").size(), 1u);
  EXPECT_EQ(all(text, "class=\"(body-[ab] seam)\"").size(), 2u);
  EXPECT_EQ(all(text, "class=\"(ghost)\"").size(), 1u);
  EXPECT_NE(description_of(third).find("unions of convex pieces"), std::string::npos);
}

TEST(UnionScene, TouchingAndDisjoint) {
  const Pieces a{box({0, 0, 0}, {1, 1, 1})}, near{box({1, 0, 0}, {2, 1, 1})}, far{box({3, 0, 0}, {4, 1, 1})};
  const PairScene touching = scene_of(a, near, union_depth(a, near));
  EXPECT_FALSE(touching.moves());
  EXPECT_TRUE(is_in(a, touching.anchor) && is_in(near, touching.anchor));
  const PairScene apart = scene_of(a, far, union_depth(a, far));
  EXPECT_EQ(apart.way, (Point{2, 0, 0}));
  UnionDepth stopped = union_depth(a, far);
  stopped.complete = false;
  EXPECT_THROW(scene_of(a, far, stopped), std::invalid_argument);
}

TEST(UnionScene, ManyEdgesAreLeftOut) {
  const View view(Point{1, 0, 0}, std::nullopt);
  Pieces some, many;
  for (int i = 0; i < 100; ++i) (i < 20 ? some : many).push_back(box({i, 0, 0}, {i + 1, 1, 1}));
  for (const Wires& piece : compound_of(some, view).pieces)
    EXPECT_TRUE(!piece.wires.empty() && std::ranges::none_of(piece.wires, &Wires::Wire::hidden));
  for (const Wires& piece : compound_of(many, view).pieces) EXPECT_TRUE(piece.wires.empty());
}

// ---- outlines ----

std::vector<Dot> square(double x, double y, double side) {
  return outline(std::vector<Dot>{{x, y}, {x + side, y}, {x, y + side}, {x + side, y + side}});
}

double length(const std::vector<std::pair<Dot, Dot>>& segments) {
  return std::accumulate(segments.begin(), segments.end(), 0.0, [](double sum, const auto& s) {
    return sum + std::hypot(s.second.x - s.first.x, s.second.y - s.first.y);
  });
}

TEST(UnitedOutline, IsThatOfTheUnion) {
  EXPECT_NEAR(length(united_outline({square(0, 0, 10)})), 40, 1e-9);
  EXPECT_NEAR(length(united_outline({square(0, 0, 10), square(20, 0, 10)})), 80, 1e-9) << "apart";
  EXPECT_NEAR(length(united_outline({square(0, 0, 10), square(10, 0, 10)})), 60, 1e-9) << "law: a seam is no outline";
  EXPECT_NEAR(length(united_outline({square(0, 0, 10), square(5, 5, 10)})), 60, 0.5)
      << "law: what lies in another is no outline";
  EXPECT_NEAR(length(united_outline({square(0, 0, 10), square(2, 2, 4)})), 40, 1e-9)
      << "law: a piece inside adds nothing";
}

// A naive twin: of a side of a square of whole numbers a unit step is outline if the unit square
// just outside it is in no other.
TEST(UnitedOutline, AgreesWithCounting) {
  std::mt19937_64 random(7);
  const auto next = [&](unsigned below) { return static_cast<int>(random() % below); };
  for (int round = 0; round < 50; ++round) {
    struct Square {
      int x, y, side;
    };
    std::vector<Square> squares;
    std::vector<std::vector<Dot>> polygons;
    for (int i = 0; i < 5; ++i) {
      squares.push_back({next(12), next(12), 1 + next(6)});
      polygons.push_back(square(squares.back().x, squares.back().y, squares.back().side));
    }
    const auto covered = [&](int x, int y, std::size_t but) {
      for (std::size_t i = 0; i < squares.size(); ++i)
        if (const Square& s = squares[i]; i != but && s.x <= x && x < s.x + s.side && s.y <= y && y < s.y + s.side)
          return true;
      return false;
    };
    int expected = 0;
    for (std::size_t i = 0; i < squares.size(); ++i)
      for (int k = 0; k < squares[i].side; ++k) {
        const Square& s = squares[i];
        expected += !covered(s.x + k, s.y - 1, i) + !covered(s.x + k, s.y + s.side, i) + !covered(s.x - 1, s.y + k, i) +
                    !covered(s.x + s.side, s.y + k, i);
      }
    EXPECT_NEAR(length(united_outline(polygons)), expected, 1) << "law: to within a few twentieths of a pixel";
  }
}

}  // namespace
}  // namespace fathom::picture
