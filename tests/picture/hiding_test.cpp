// SPDX-License-Identifier: GPL-3.0-or-later
// What the pieces of a body hide of each other's edges: known pictures, and at random against
// looking from single places.

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "fathom/numbers.hpp"
#include "tests/support/boxes.hpp"
#include "tests/support/property.hpp"
#include "view/picture/drawn.hpp"
#include "view/picture/markup.hpp"
#include "view/picture/scene.hpp"
#include "view/picture/view.hpp"

namespace fathom::picture {
namespace {

using testing::box;
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
  const Solid lower = box({-1, -6, -1}, {1, 6, 1});
  for (const int sunk : {0, 1}) {  // 1: the bars have a common part
    const Compound body = compound_of({box({-6, -1, 1 - sunk}, {6, 1, 3 - sunk}), lower}, from_above);
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
    const Compound body =
        compound_of({box({0, 0, 0}, at(mpq_class(1, 3))), box(low(mpq_class(1, 3)), {1, 1, 1})}, from_above);
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
      else points = box({number(), number(), number()}, {7, 8, 9});  // all with one corner, and three faces, in common
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

// The policy of pages names the texts that it allows by their digests, and nothing else.

// The digest of the example in the Content Security Policy specification, section "Usage of
// hashes".
TEST(Policy, AllowsTextsByTheirDigest) {
  const std::vector<std::string_view> scripts{"alert('Hello, world.');"}, none;
  EXPECT_EQ(security_policy(scripts, none),
            "default-src 'none'; script-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='; style-src 'none'; "
            "img-src data:; "
            "base-uri 'none'; form-action 'none'");
  EXPECT_EQ(security_policy(none, scripts),
            "default-src 'none'; script-src 'none'; style-src 'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='; "
            "img-src data:; "
            "base-uri 'none'; form-action 'none'");
}

TEST(Policy, IsAnElement) {
  EXPECT_EQ(policy_element({}, {}),
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'none'; style-src "
            "'none'; img-src data:; "
            "base-uri 'none'; form-action 'none'\"/>");
}

// Paths and polygons: cut at a box, around dots; and exactly, where doubles would lose what lies in
// the box.

TEST(Clipped, Segments) {
  const auto cut = [](Dot from, Dot to) { return clipped(std::vector<Dot>{from, to}, false, {-1, -2}, {1, 2}); };
  auto part = cut({-3, 0}, {3, 0});
  ASSERT_EQ(part.size(), 2u);
  EXPECT_EQ(std::pair(part[0].x, part[1].x), std::pair(-1.0, 1.0));
  part = cut({0, 0}, {0, 8});
  ASSERT_EQ(part.size(), 2u);
  EXPECT_EQ(part[1].y, 2);
  EXPECT_TRUE(cut({-3, 0}, {0, 9}).empty()) << "past the corner";
  EXPECT_TRUE(cut({0, 0}, {std::nan(""), 0}).empty());
  EXPECT_TRUE(cut({0, 0}, {INFINITY, 0}).empty());
}

TEST(Clipped, PolygonsStayInTheBox) {
  EXPECT_TRUE(holds({.seed = 75, .runs = 1000}, [] {
    const auto coordinate = rc::gen::inRange(-30, 31);
    std::vector<Dot> dots;
    for (int i = 0; i < 8; ++i) dots.push_back({*coordinate / 10.0, *coordinate / 10.0});
    for (const Dot& d : clipped(outline(dots), true, {-1, -1}, {1, 1}))
      RC_ASSERT(std::abs(d.x) < 1 + 1e-12 && std::abs(d.y) < 1 + 1e-12);
  }));
  EXPECT_EQ(clipped(std::vector<Dot>{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, true, {-1, -1}, {1, 1}).size(), 4u);
}

TEST(Outline, HasTheCornersOfTheHullOnly) {
  EXPECT_EQ(outline(std::vector<Dot>{{0, 0}, {2, 0}, {1, 0}, {1, 1}, {2, 2}, {0, 2}, {0, 0}, {1, 2}}).size(), 4u);
  EXPECT_EQ(outline(std::vector<Dot>{{0, 0}, {1, 1}, {2, 2}}).size(), 2u) << "a segment";
  EXPECT_EQ(outline(std::vector<Dot>{{3, 4}}).size(), 1u);
}

// Through the box at a third of its height, between ends that doubles cannot tell from whole ones.
TEST(Clipped, OfPlacesIsExact) {
  const mpq_class far("1" + std::string(600, '0')), third(1, 3);
  const Spot low{-1, -1}, high{1, 1};
  const std::vector<Spot> part = clipped(std::vector<Spot>{{mpq_class(-far), third}, {far, third}}, false, low, high);
  ASSERT_EQ(part.size(), 2u);
  EXPECT_EQ(part[0].x, -1);
  EXPECT_EQ(part[0].y, third);
  const std::vector<Spot> wedge{{0, 0}, {far, far}, {far, mpq_class(-far)}, {far, 0}};
  const std::vector<Spot> seen = clipped(outline(wedge), true, low, high);
  ASSERT_EQ(seen.size(), 3u) << "the apex, and two corners of the box";
}

// Rims: where the ends of cylinders, cones and frusta meet their sides; the half behind is hidden.
// A naive twin finds what is seen by rays.

/// x to the right, z up and a little towards us: the cap of a cylinder along z is seen.
View seen_from_above() { return {Point{1, 0, 0}, Point{0, 1, 2}}; }
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
  const std::vector<Rim> found = rims(cylinder(2, 3), seen_from_above());
  ASSERT_EQ(found.size(), 3u) << "law: the upper rim is seen; of the lower one a half is hidden";
  EXPECT_EQ(points(found, false), 96u + 48u);
  EXPECT_EQ(points(found, true), 48u);
  for (const Rim& rim : found)
    for (const Point& p : rim.path) {
      EXPECT_NEAR(radius(p), 2, 1e-12);
      EXPECT_NEAR(std::abs(p.z.get_d()), 3, 1e-12);
      const double nearness = dot(Vec3<double>{p.x.get_d(), p.y.get_d(), 0}, seen_from_above().towards());
      EXPECT_TRUE(!rim.hidden || nearness < 0.2) << "law: the far side is hidden";
    }
}

TEST(Rims, OfOtherBodies) {
  EXPECT_EQ(rims(cone(2, 3), seen_from_above()).size(), 2u) << "a cone has one, half of it behind";
  EXPECT_EQ(rims(frustum(2, 1, 3), seen_from_above()).size(), 3u);
  EXPECT_EQ(rims(cone(2, 3, Axis::y), seen_from_above()).size(), 1u) << "seen from its base";
  EXPECT_TRUE(rims(sphere(1), seen_from_above()).empty());
  EXPECT_TRUE(rims(capsule(1, 2), seen_from_above()).empty());
  EXPECT_TRUE(rims(ellipsoid({1, 2, 3}), seen_from_above()).empty());
  EXPECT_TRUE(rims(with_margin(cylinder(1, 2), mpq_class(1, 10)), seen_from_above()).empty())
      << "what is rounded has no edges";
  EXPECT_EQ(points(rims(cylinder(2, 3), from_beside()), true), 0u) << "law: an end seen from its edge hides nothing";
}

TEST(Rims, OfAFlatConeAllOfItIsSeen) {
  const std::vector<Rim> found =
      rims(cone(10, mpq_class(1, 4)), seen_from_above());  // the apex points to us more than its side is steep
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
  const View view = seen_from_above();
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
