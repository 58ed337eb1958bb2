// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two bodies overlap, and whether they are closer than a distance: without their depth, and
// with the numbers that prove it.
#include <fathom/overlap.hpp>
#include <iostream>
#include <vector>

fathom::Body cube(const mpq_class& x) {
  std::vector<fathom::Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({x + (i & 1), mpq_class(i >> 1 & 1), mpq_class(i >> 2)});
  fathom::Body body;
  body.points = std::move(corners);
  return body;
}

int main() {
  const fathom::Body a = cube(0), b = cube(mpq_class(3, 2));

  // Many questions, one after another, share memory.
  fathom::Workspace workspace;
  for (const mpq_class& x : {mpq_class(1, 2), mpq_class(1), mpq_class(3, 2)})
    std::cout << name(*fathom::overlap(a, cube(x), {.workspace = &workspace}).status) << "\n";

  // Exactly 1/2 apart is not closer than 1/2.
  std::cout << *fathom::closer_than(a, b, mpq_class(1, 2)).closer
            << *fathom::closer_than(a, b, mpq_class(5001, 10000)).closer << "\n";

  const fathom::OverlapProof apart = *fathom::overlap(a, b, {.proof = true}).proof;
  std::cout << "the planes across (" << apart.normal->x << ", " << apart.normal->y << ", " << apart.normal->z
            << ") separate them\n";
  const fathom::ClosenessProof close = *fathom::closer_than(a, b, 1, {.proof = true}).proof;
  std::cout << "x = " << close.points->a.x << " of A and x = " << close.points->b.x << " of B are close\n";
}

//> penetrating
//> touching
//> disjoint
//> 01
//> the planes across (-1, 0, 0) separate them
//> x = 1 of A and x = 3/2 of B are close
