// SPDX-License-Identifier: GPL-3.0-or-later
// How deep do two cubes of side 2 overlap, the second moved by (19/10, 1/2, 0), and which way out
// is shortest?
#include <fathom/depth.hpp>
#include <fathom/numbers.hpp>
#include <iostream>
#include <vector>

std::vector<fathom::Point> cube(const mpq_class& x, const mpq_class& y) {
  std::vector<fathom::Point> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back({x + (i & 1 ? 1 : -1), y + (i & 2 ? 1 : -1), mpq_class(i & 4 ? 1 : -1)});
  }
  return corners;
}

int main() {
  const std::vector<fathom::Point> a = cube(0, 0), b = cube(mpq_class(19, 10), mpq_class(1, 2));
  const fathom::Depth depth = fathom::penetration_depth(a, b);
  std::cout << "depth^2 = " << depth.squared() << "\n";                         // exact
  std::cout << "depth   ~ " << fathom::root_binary64(depth.squared()) << "\n";  // correctly rounded
  const fathom::Point way_out = depth.translation();
  std::cout << "A moves by (" << way_out.x << ", " << way_out.y << ", " << way_out.z << ")\n";
}

//> depth^2 = 1/100
//> depth   ~ 0.1
//> A moves by (-1/10, 0, 0)
