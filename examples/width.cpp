// SPDX-License-Identifier: GPL-3.0-or-later
// The width of a body: between which two parallel planes does it fit best?
#include <fathom/width.hpp>
#include <iostream>
#include <vector>

int main() {
  const std::vector<fathom::Point> tetrahedron{{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  const fathom::Depth width = fathom::width(tetrahedron);
  const fathom::Vector& n = width.direction();
  std::cout << "width^2 = " << width.squared() << ", across (" << n.x << ", " << n.y << ", " << n.z << ") and "
            << width.optima().size() - 1 << " more directions\n";
}

//> width^2 = 1, across (-1, 0, 0) and 5 more directions
