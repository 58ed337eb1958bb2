// SPDX-License-Identifier: GPL-3.0-or-later
// Other depths of two bodies: along a direction, in a norm, within a factor, and by the facets near
// the origin alone; and by which factor bodies grow until they touch.
#include <fathom/approximate.hpp>
#include <iostream>
#include <vector>

using fathom::Point;

const std::vector<Point> octahedron{{2, 0, 0}, {-2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 2}, {0, 0, -2}};

std::vector<Point> cube(const mpq_class& x) {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({x + (i & 1 ? 1 : -1), mpq_class(i & 2 ? 1 : -1), mpq_class(i & 4 ? 1 : -1)});
  return corners;
}

int main() {
  const std::vector<Point> a = octahedron, b = cube(mpq_class(3, 2));

  // A body can move along rails: how far must it go?
  const fathom::DirectionalDepth along = fathom::directional_depth(a, b, {-1, -1, 0});
  std::cout << "along (-1, -1, 0): " << along.factor() << " times, length^2 = " << along.squared() << ", normal ("
            << along.normal().x << ", " << along.normal().y << ", " << along.normal().z << "), contact "
            << fathom::name(along.penetration()->contact.kind) << ", y moves by " << along.translation().y << "\n";

  // The depth in the norm whose unit ball is an octahedron: the least |x| + |y| + |z|.
  const fathom::UnitBall ball =
      fathom::unit_ball(std::vector<Point>{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  const fathom::MetricResult metric = fathom::metric_depth(a, b, ball);
  std::cout << "in the norm: " << metric.depth() << ", " << metric.optima().size() << " optimum, across ("
            << metric.direction().x << ", " << metric.direction().y << ", " << metric.direction().z << ")\n";
  try {
    (void)fathom::unit_ball(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  } catch (const fathom::NoUnitBall& error) {
    std::cout << "no ball: " << error.what() << "\n";
  }

  // At most a tenth too long, by a few rays.
  const fathom::ApproxDepth approx = fathom::approx_depth(a, b, mpq_class(1, 10));
  const fathom::Depth exact = fathom::shallow_depth(a, b);
  std::cout << "within a tenth: " << (approx.bound_squared() <= exact.squared() && exact.squared() <= approx.squared())
            << ", separates by (" << approx.translation().x << ", " << approx.translation().y << ", "
            << approx.translation().z << "), a multiple of (" << approx.direction().x << ", " << approx.direction().y
            << ", " << approx.direction().z << ")\n";
  std::cout << "exact: depth^2 = " << exact.squared() << "\n";
  std::cout << "width of the octahedron: width^2 <= " << fathom::approx_width(octahedron, mpq_class(1, 10)).squared()
            << ", exactly " << fathom::width(octahedron).squared() << "\n";

  // Many questions about the same bodies.
  const fathom::Hierarchies both(a, b);
  for (const Point& direction : {Point{-1, 0, 0}, Point{0, 1, 0}, Point{0, 0, -1}}) {
    std::cout << both.directional_depth(direction).factor() << " ";
  }
  std::cout << both.metric_depth(ball).depth() << " "
            << (both.approx_depth(mpq_class(1, 2)).bound_squared() <= exact.squared()) << "\n";

  // Bodies that do not penetrate have a plane between them.
  const fathom::DirectionalDepth apart = fathom::directional_depth(a, cube(4), {1, 0, 0});
  std::cout << fathom::name(apart.status()) << ": normal (" << apart.separation()->normal.x << ", 0, 0)\n";

  // Apart or not: by which factor do both grow about their centers until they touch?
  const fathom::GrowthDistance growth = fathom::growth_distance(a, cube(4));
  const fathom::Witness met = growth.touch->witness;
  std::cout << fathom::name(growth.status()) << ": growth " << growth.growth << " about x = " << growth.center_a.x
            << " and " << growth.center_b.x << ", then x = " << growth.growth * met.a.x << " is in both\n";
  std::cout << "about another center of B: " << fathom::growth_distance(a, cube(4), {}, Point{5, 0, 0}).growth << "\n";
  try {
    (void)fathom::growth_distance(a, cube(4), Point{-2, 0, 0}, Point{5, 0, 0});
  } catch (const fathom::NoGrowth& error) {
    std::cout << "no growth: " << error.what() << "\n";
  }
}

//> along (-1, -1, 0): 5/4 times, length^2 = 25/8, normal (-1, -1, 0), contact edge-edge, y moves by -5/4
//> in the norm: 3/2, 1 optimum, across (-1, 0, 0)
//> no ball: the unit ball has O on its boundary, which must lie inside it
//> within a tenth: 1, separates by (-3/2, 0, 0), a multiple of (-1, 0, 0)
//> exact: depth^2 = 9/4
//> width of the octahedron: width^2 <= 16/3, exactly 16/3
//> 3/2 5/2 5/2 3/2 1
//> disjoint: normal (-1, 0, 0)
//> disjoint: growth 4/3 about x = 0 and 4, then x = 8/3 is in both
//> about another center of B: 5/4
//> no growth: expected centers with center_b - center_a inside B - A, found it on the boundary
