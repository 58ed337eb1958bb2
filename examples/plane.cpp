// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of the plane: two squares, and a circle beside one of them.
#include <fathom/answer.hpp>
#include <fathom/plane.hpp>
#include <iostream>

int main() {
  const fathom::Body square = fathom::in_plane({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}});
  const fathom::Body other = fathom::in_plane({{{1, mpq_class(1, 2), 0}, {3, 1, 0}, {2, 3, 0}}});
  fathom::Body disc;
  disc.shape = fathom::sphere(mpq_class(1, 2));
  for (const fathom::Body& b : {other, fathom::in_plane(disc)}) {
    const fathom::Answer answer = fathom::exact_answer(square, b);
    const fathom::Vector n = *answer.direction();
    std::cout << answer.status_name() << " " << *answer.nearest_binary64() << " (" << n.x << ", " << n.y << ") "
              << name(answer.contact()->kind) << ", dimension " << answer.dimension() << "\n";
  }
}

//> penetrating 1 (-1, 0) edge-vertex, dimension 2
//> penetrating 0.5 (0, 1) vertex-vertex, dimension 2
