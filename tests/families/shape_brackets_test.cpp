// SPDX-License-Identifier: GPL-3.0-or-later
// Random shapes against other ways to their signed depth: segments in closed form, and polytopes
// inside and outside of discs and balls.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "fathom/signed_depth.hpp"
#include "kernels/vector.hpp"
#include "verify/families/families.hpp"

namespace fathom::families {
namespace {

// ---- segments ----

struct Segment {
  Point p, q;
};

Segment core(const Shape& shape) {
  const std::vector<Atom>& atoms = std::get<std::vector<Term>>(shape.core).front().atoms;
  return {atoms.front().center, atoms.back().center};
}

mpq_class squared_distance(const Point& point, const Segment& s) {
  const Point along = s.q - s.p, to = point - s.p;
  const mpq_class length = dot(along, along);
  mpq_class t = length == 0 ? mpq_class(0) : mpq_class(dot(to, along) / length);
  t = std::clamp<mpq_class>(t, 0, 1);
  const Point gap = to - t * along;
  return dot(gap, gap);
}

/// The least of: each end to the other segment; the common perpendicular, if both its feet are on
/// the segments.
mpq_class squared_distance(const Segment& s, const Segment& t) {
  mpq_class least = std::min(
      {squared_distance(s.p, t), squared_distance(s.q, t), squared_distance(t.p, s), squared_distance(t.q, s)});
  const Point u = s.q - s.p, v = t.q - t.p, w = t.p - s.p;
  const mpq_class uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  if (determinant == 0) return least;
  const mpq_class x = (dot(w, u) * vv - dot(w, v) * uv) / determinant,
                  y = (dot(w, u) * uv - dot(w, v) * uu) / determinant;
  if (x < 0 || x > 1 || y < 0 || y > 1) return least;
  const Point gap = w + y * v - x * u;
  return std::min<mpq_class>(least, dot(gap, gap));
}

TEST(RandomShapes, SpheresAndCapsulesHaveTheDistanceOfTheirSegments) {
  for (const char* name :
       {"spheres", "capsules", "sphere_capsule", "inverse_sphere_sphere", "inverse_cap_cap", "inverse_side_side"})
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const ShapeCase shapes = find_family(name)->make_shapes(seed, 1);
      const Shape a = shape_of(shapes.pair.a), b = shape_of(shapes.pair.b);
      const SignedDepth depth = signed_depth(a, b);
      ASSERT_TRUE(depth.exact()) << shapes.id;
      const Surd expected{a.radius + b.radius, -squared_distance(core(a), core(b))};
      EXPECT_EQ(compare(*depth.exact(), expected), 0) << shapes.id;
    }
}

// ---- polytopes inside and outside ----

/// Points of the unit circle, and the corners of the polygon that touches it there.
struct Polygons {
  std::vector<Point> inside, outside;
};

const Polygons& polygons() {
  static const Polygons both = [] {
    Polygons result;
    for (int quarter = 0; quarter < 4; ++quarter)
      for (int i = 0; i < 4; ++i) {
        const mpq_class t(i, 4), scale = 1 / (1 + t * t);
        Point p{(1 - t * t) * scale, 2 * t * scale, 0};
        for (int turn = 0; turn < quarter; ++turn) p = {-p.y, p.x, 0};
        result.inside.push_back(p);
      }
    for (std::size_t i = 0; i < result.inside.size(); ++i) {
      const Point &p = result.inside[i], &q = result.inside[(i + 1) % result.inside.size()];
      result.outside.push_back((1 / (1 + dot(p, q))) * (p + q));
    }
    return result;
  }();
  return both;
}

/// Points of the unit sphere, and the same blown up until their hull holds the ball.
const Polygons& polyhedra() {
  static const Polygons both = [] {
    Polygons result;
    const std::array<Point, 3> kinds{
        {{1, 0, 0}, {mpq_class(3, 5), mpq_class(4, 5), 0}, {mpq_class(2, 3), mpq_class(2, 3), mpq_class(1, 3)}}};
    for (const Point& p : kinds)
      for (const Point& q : {Point{p.x, p.y, p.z}, Point{p.y, p.z, p.x}, Point{p.z, p.x, p.y}, Point{p.y, p.x, p.z},
                             Point{p.x, p.z, p.y}, Point{p.z, p.y, p.x}})
        for (unsigned signs = 0; signs < 8; ++signs)
          result.inside.push_back({signs & 1 ? mpq_class(-q.x) : q.x, signs & 2 ? mpq_class(-q.y) : q.y,
                                   signs & 4 ? mpq_class(-q.z) : q.z});
    const std::vector<Point> center{{}};
    const mpq_class inner =
        exact_value(root_binary64(penetration_depth(result.inside, center).squared(), Rounding::rd));
    for (const Point& p : result.inside) result.outside.push_back((1 / inner) * p);
    return result;
  }();
  return both;
}

/// The shape with points instead of discs and balls.
Shape polytope_of(const Shape& shape, std::vector<Point> Polygons::*which) {
  if (std::holds_alternative<HalfSpace>(shape.core)) return shape;
  std::vector<Term> terms;
  for (const Term& term : std::get<std::vector<Term>>(shape.core)) {
    Term& points = terms.emplace_back();
    for (const Atom& atom : term.atoms) {
      if (atom.axes.empty()) points.atoms.push_back(atom);
      else
        for (const Point& local : (atom.axes.size() == 2 ? polygons() : polyhedra()).*which) {
          Point p = atom.center + local.x * atom.axes[0] + local.y * atom.axes[1];
          if (atom.axes.size() == 3) p = p + local.z * atom.axes[2];
          points.atoms.push_back({p, {}});
        }
    }
  }
  return {terms, shape.radius};
}

int compare_with_low(const SignedDepth& depth, const Surd& value) {
  return depth.exact() ? compare(value, *depth.exact()) : compare(value, depth.bounds()->low);
}

int compare_with_high(const SignedDepth& depth, const Surd& value) {
  return depth.exact() ? compare(value, *depth.exact()) : compare(value, depth.bounds()->high);
}

TEST(RandomShapes, LieBetweenPolytopesInsideAndOutside) {
  for (const Family& family : fathom::families::families(Kind::shapes)) {
    if (family.name == "sums") continue;  // sums of two solids have too many points
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const ShapeCase shapes = family.make_shapes(seed, 8);
      if (shapes.pair.a.shape == "sum" || shapes.pair.b.shape == "sum") continue;
      const Shape a = shape_of(shapes.pair.a), b = shape_of(shapes.pair.b);
      const SignedDepth depth = signed_depth(a, b);
      const SignedDepth inside = signed_depth(polytope_of(a, &Polygons::inside), polytope_of(b, &Polygons::inside));
      const SignedDepth outside = signed_depth(polytope_of(a, &Polygons::outside), polytope_of(b, &Polygons::outside));
      ASSERT_TRUE(inside.exact() && outside.exact()) << shapes.id;
      EXPECT_LE(compare_with_high(depth, *inside.exact()), 0) << shapes.id;
      EXPECT_GE(compare_with_low(depth, *outside.exact()), 0) << shapes.id;
    }
  }
}

}  // namespace
}  // namespace fathom::families
