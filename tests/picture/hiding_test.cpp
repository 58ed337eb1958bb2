// SPDX-License-Identifier: GPL-3.0-or-later
// What the pieces of a body hide of each other's edges: known pictures, and at random against
// looking from single places.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>

#include "tests/support/boxes.hpp"
#include "view/picture/drawn.hpp"

namespace fathom::picture {
namespace {

using testing::box_points;
using Solid = std::vector<Point>;

/// The total length of the wires that run along an axis, by its number, which are hidden or not.
mpq_class length(const std::vector<Wires::Wire>& wires, int axis, bool hidden) {
  mpq_class result = 0;
  for (const Wires::Wire& wire : wires) {
    const Point d = wire.to - wire.from;
    const std::array<mpq_class, 3> along{d.x, d.y, d.z};
    if (wire.hidden == hidden) result += abs(along[static_cast<std::size_t>(axis)]);
  }
  return result;
}

/// From above, a little from the front and from the right.
const View from_above(Point{1, 0, mpq_class(-1, 4)}, Point{0, 1, mpq_class(1, 4)});

// A bar along x lies over one along y, and through it: the upper hides of the lower what it
// crosses.
TEST(Hiding, CrossingBars) {
  ASSERT_GT(from_above.towards().z, 0.9);
  const Solid lower = box_points({-1, -6, -1}, {1, 6, 1});
  for (const int sunk : {0, 1}) {  // 1: the bars have a common part
    const Compound body = compound_of({box_points({-6, -1, 1 - sunk}, {6, 1, 3 - sunk}), lower}, from_above);
    const std::vector<Wires::Wire>& wires = body.pieces[1].wires;
    EXPECT_EQ(length(wires, 1, true) + length(wires, 1, false), 48) << "law: no part of an edge is lost";
    // Of the lower bar's edges along y one is hidden by the bar itself, and two at the top by the
    // other bar where it stands on them; a look rises by 4 while it moves by 1 along y, so the two
    // at the bottom that are seen are hidden where it has moved in under the upper bar.
    EXPECT_GT(length(wires, 1, true), 12 + 4);
    EXPECT_LT(length(wires, 1, true), 12 + 2 * 3 + 2 * 4);
    const Compound alone = compound_of({lower}, from_above);
    EXPECT_EQ(length(alone.pieces[0].wires, 1, true), 12);
    // Of the upper bar the lower one hides what sticks in it.
    EXPECT_EQ(length(body.pieces[0].wires, 0, true) > 12, sunk == 1)
        << "law: an edge inside another piece is hidden, one above is not";
  }
}

// A cube cut in two: the seam is seen on the faces that are seen, twice, and hidden where the faces
// are.
TEST(Hiding, SeamsOnTheSurfaceAreSeen) {
  for (const int axis : {0, 1, 2}) {
    const auto at = [&](const mpq_class& p) { return Point{axis == 0 ? p : 1, axis == 1 ? p : 1, axis == 2 ? p : 1}; };
    const auto low = [&](const mpq_class& p) { return Point{axis == 0 ? p : 0, axis == 1 ? p : 0, axis == 2 ? p : 0}; };
    const Compound body = compound_of(
        {box_points({0, 0, 0}, at(mpq_class(1, 3))), box_points(low(mpq_class(1, 3)), {1, 1, 1})}, from_above);
    for (const Wires& piece : body.pieces) {
      mpq_class hidden = 0, seen = 0;
      for (const Wires::Wire& wire : piece.wires) {
        const auto on_seam = [&](const Point& p) {
          return (axis == 0 ? p.x : axis == 1 ? p.y : p.z) == mpq_class(1, 3);
        };
        if (!on_seam(wire.from) || !on_seam(wire.to)) continue;
        const Point d = wire.to - wire.from;
        (wire.hidden ? hidden : seen) += abs(d.x) + abs(d.y) + abs(d.z);
      }
      EXPECT_EQ(seen, 2) << "law: the seam is seen on two faces, cut along " << axis;
      EXPECT_EQ(hidden, 2) << "law: and hidden on two, cut along " << axis;
    }
  }
}

// A look along a plane is rounded: it leaves the plane to either side. Bodies on both sides of it,
// one behind the other, hide nothing in it.
TEST(Hiding, FacesSeenFromTheirEdge) {
  for (int p = 1; p <= 7; ++p)
    for (const int q : {-5, 3, 11}) {
      const View along_plane(Point{0, 0, 1}, Point{p, q, 0});
      const Point out{p, q, 0}, ahead{q, -p, 0}, up{0, 0, 1};
      for (const int side : {-1, 1}) {
        const Solid here{{0, 0, 0}, ahead, up, ahead + up, out, out + up};
        Solid there;
        for (const Point& x : {Point{}, -ahead, side * out}) there.push_back(x), there.push_back(x + up);
        for (const Wires& piece : compound_of({here, there}, along_plane).pieces)
          for (const Wires::Wire& wire : piece.wires)
            EXPECT_FALSE(wire.hidden && dot(wire.from, out) == 0 && dot(wire.to, out) == 0)
                << "plane " << p << ' ' << q;
      }
    }
}

// ---- naive twin ----

/// An outward half-space: <normal, x> <= offset in the body.
struct HalfSpaceOf {
  Point normal;
  mpq_class offset;
};

/// Of all planes through three of the points those that have all points on one side.
std::vector<HalfSpaceOf> half_spaces(const Solid& points) {
  std::vector<HalfSpaceOf> result;
  for (const Point& p : points)
    for (const Point& q : points)
      for (const Point& r : points) {
        const Point u = q - p, v = r - p;
        const Point n{mpq_class(u.y * v.z - u.z * v.y), mpq_class(u.z * v.x - u.x * v.z),
                      mpq_class(u.x * v.y - u.y * v.x)};
        if (n.x == 0 && n.y == 0 && n.z == 0) continue;
        const mpq_class offset = dot(n, p);
        if (std::ranges::all_of(points, [&](const Point& x) { return dot(n, x) <= offset; }))
          result.push_back({n, offset});
      }
  return result;
}

/// Whether the look from the place enters the interior.
bool hides(const std::vector<HalfSpaceOf>& body, const Point& place, const Point& look) {
  mpq_class from = 0;
  std::optional<mpq_class> to;
  for (const HalfSpaceOf& half : body) {
    const mpq_class room = half.offset - dot(half.normal, place), turn = dot(half.normal, look);
    if (turn == 0 && room <= 0) return false;
    if (turn < 0) from = std::max(from, mpq_class(room / turn));
    if (turn > 0) to = to ? std::min(*to, mpq_class(room / turn)) : mpq_class(room / turn);
  }
  return to && from < *to;
}

TEST(Hiding, AgreesWithLooksFromSinglePlaces) {
  std::mt19937_64 random(11);
  const auto number = [&] { return mpq_class(static_cast<long>(random() % 13) - 6); };
  const View view(Point{1, 0, 0}, std::nullopt);
  std::size_t parted = 0, asked = 0;
  for (int round = 0; round < 12; ++round) {
    std::vector<Solid> pieces;
    std::vector<std::vector<HalfSpaceOf>> bodies;
    while (pieces.size() < 5) {
      Solid points;
      if (pieces.size() % 2 == 0)
        for (int i = 0; i < 5; ++i) points.push_back({number(), number(), number()});
      else
        points =
            box_points({number(), number(), number()}, {7, 8, 9});  // all with one corner, and three faces, in common
      std::vector<HalfSpaceOf> halves = half_spaces(points);
      const auto flat = [&](const HalfSpaceOf& h) {
        return std::ranges::all_of(points, [&](const Point& p) { return dot(h.normal, p) == h.offset; });
      };
      if (std::ranges::any_of(halves, flat)) continue;
      pieces.push_back(std::move(points));
      bodies.push_back(std::move(halves));
    }
    for (const Wires& piece : compound_of(pieces, view).pieces) {
      for (const Wires::Wire& wire : piece.wires)
        for (const int share : {1, 40, 99}) {  // of a hundred
          const Point place = wire.from + mpq_class(share, 100) * (wire.to - wire.from);
          const bool is_hidden =
              std::ranges::any_of(bodies, [&](const auto& body) { return hides(body, place, view.look()); });
          EXPECT_EQ(wire.hidden, is_hidden) << "law: hidden is what a piece hides; round " << round;
          ++asked;
        }
      for (std::size_t i = 1; i < piece.wires.size(); ++i)
        parted += piece.wires[i - 1].to == piece.wires[i].from && piece.wires[i - 1].hidden != piece.wires[i].hidden;
    }
  }
  EXPECT_GT(parted, 50u) << "else the cases have to be others";
  EXPECT_GT(asked, 1000u);
}

}  // namespace
}  // namespace fathom::picture
