// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the exact depth of two cubes of side 2, the second moved by (19/10, 1/2, 0).
#include <fathom/fathom.hpp>
#include <fathom/verify/check/check.hpp>
#include <iostream>
#include <vector>

#ifdef CGAL_VERSION
#error "CGAL leaks through the installed headers"
#endif

std::vector<fathom::Point> cube(const mpq_class& x, const mpq_class& y) {
  std::vector<fathom::Point> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back({mpq_class(x + (i & 1 ? 1 : -1)), mpq_class(y + (i & 2 ? 1 : -1)), mpq_class(i & 4 ? 1 : -1)});
  }
  return corners;
}

int main() {
  const fathom::Depth depth = fathom::penetration_depth(cube(0, 0), cube(mpq_class(19, 10), mpq_class(1, 2)));
  std::cout << "depth^2 " << depth.squared() << " along " << depth.direction()->x << " " << depth.direction()->y << " " << depth.direction()->z
            << "\n";
  return fathom_check::verify("no certificate").accepted() ? 1 : 0;
}
