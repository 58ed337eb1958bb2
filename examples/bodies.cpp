// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies keep their points in the form in which they were given: in binary64, as most programs have
// them, or exact.
#include <algorithm>
#include <array>
#include <fathom/body.hpp>
#include <fathom/depth.hpp>
#include <iostream>
#include <vector>

void tell(const fathom::GivenPoints& points) {
  if (points.empty()) std::cout << "no points\n";
  else if (points.in_binary64())
    std::cout << points.size() << " in binary64, the last " << points.binary64().back()[0] << "...\n";
  else std::cout << points.size() << " exact, the last " << points.back().x << "...\n";
}

int main() {
  std::vector<std::array<double, 3>> corners;
  for (const double x : {0.0, 0.5})
    for (const double y : {0.0, 1.0})
      for (const double z : {0.0, 1.0}) corners.push_back({x, y, z});
  const fathom::Body a{fathom::GivenPoints(corners)};
  fathom::Body b;
  tell(b.points);
  b.points.reserve(a.points.size());
  for (const fathom::Point& p : a.points) b.points.push_back({p.x * 3, p.y, p.z});
  for (fathom::Point& p : b.points.edit()) p.x -= mpq_class(1, 3);
  tell(a.points);
  tell(b.points);

  const fathom::Depth depth = fathom::penetration_depth(a, b);
  std::cout << "depth^2 " << depth.squared() << ", next " << *fathom::second_nearest_squared(a, b, *depth.penetration())
            << "\n";
  const auto by_x = [](const fathom::Point& p, const fathom::Point& q) { return p.x < q.x; };
  const fathom::Point* const farthest = std::max_element(b.points.begin(), b.points.end(), by_x);
  std::cout << "point " << farthest - b.points.data() << " lies at " << farthest->x.get_d() << ", the first at "
            << b.points.front().x << " " << b.points[0].y << "\n";
}

//> no points
//> 8 in binary64, the last 0.5...
//> 8 exact, the last 7/6...
//> depth^2 25/36, next 1
//> point 4 lies at 1.16667, the first at -1/3 0
