// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies keep their points in the form in which they were given: in binary64, as most programs have
// them, or exact. Then many small ones, as a physics engine has them: one workspace for all, no
// rationals on the way, and a proof of each answer.
#include <algorithm>
#include <array>
#include <fathom/body.hpp>
#include <fathom/certificate.hpp>
#include <fathom/check.hpp>
#include <fathom/depth.hpp>
#include <fathom/numbers.hpp>
#include <iostream>
#include <vector>

void tell(const fathom::GivenPoints& points) {
  if (points.empty()) std::cout << "no points\n";
  else if (points.in_binary64())
    std::cout << points.size() << " in binary64, the last " << points.binary64().back()[0] << "...\n";
  else std::cout << points.size() << " exact, the last " << points.back().x << "...\n";
}

void keep_their_form() {
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

using Points = std::vector<std::array<double, 3>>;

Points box(double x, double y, double z) {
  Points corners;
  for (const double i : {0.0, 1.0})
    for (const double j : {0.0, 1.0})
      for (const double k : {0.0, 1.0}) corners.push_back({x + i, y + j, z + k});
  return corners;
}

void many_small() {
  fathom::Workspace workspace;
  fathom::Options options;
  options.workspace = &workspace;
  const Points a = box(0, 0, 0);
  for (const double x : {0.25, 0.9, 0.999}) {
    const Points b = box(x, 0.1, 0.1);
    const fathom::Depth depth = fathom::penetration_depth(a, b, options);
    const std::string proof = fathom::certificate_text(a, b, depth);
    std::cout << fathom::root_binary64(depth.squared())
              << (fathom_check::verify(proof).accepted() ? ", proved" : ", refused") << "\n";
  }
}

int main() {
  keep_their_form();
  many_small();
}

//> no points
//> 8 in binary64, the last 0.5...
//> 8 exact, the last 7/6...
//> depth^2 25/36, next 1
//> point 4 lies at 1.16667, the first at -1/3 0
//> 0.75, proved
//> 0.1, proved
//> 0.001, proved
