// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two bodies overlap, and whether they are closer than a distance: without their depth, and
// with the numbers that prove it. Then a body that moves: prepared once, it is asked about in one
// pose after another, as in a test that runs each frame.
#include <fathom/certificate.hpp>
#include <fathom/check.hpp>
#include <fathom/numbers.hpp>
#include <fathom/overlap.hpp>
#include <fathom/prepared.hpp>
#include <iostream>
#include <string>
#include <vector>

fathom::Body cube(const mpq_class& x) {
  std::vector<fathom::Point> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({x + (i & 1), mpq_class(i >> 1 & 1), mpq_class(i >> 2)});
  fathom::Body body;
  body.points = std::move(corners);
  return body;
}

void questions() {
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

fathom::Body box(double x, double y, double z) {
  std::vector<std::array<double, 3>> corners;
  for (int i = 0; i < 8; ++i) corners.push_back({(i & 1) ? x : -x, (i & 2) ? y : -y, (i & 4) ? z : -z});
  return {fathom::GivenPoints(corners)};
}

void moving() {
  const fathom::PlacedBody ground{fathom::Prepared(box(4, 4, 1))};
  fathom::PlacedBody die{fathom::Prepared(box(0.5, 0.5, 0.5))};
  std::cout << die.prepared.extreme_points().size() << " extreme points of " << die.prepared.body().points.size()
            << "\n";

  // One frame after another: the search begins where the last one ended.
  fathom::Workspace workspace;
  fathom::WarmStart start;
  for (const double height : {1.75, 1.5, 1.375}) {
    die.pose = fathom::PoseBinary64{{{0.6, -0.8, 0, 1}, {0.8, 0.6, 0, 2}, {0, 0, 1, height}}};
    const fathom::Depth depth = penetration_depth(die, ground, &start, {.workspace = &workspace});
    std::cout << name(depth.status()) << " " << fathom::root_binary64(depth.squared()) << "\n";
  }
  std::cout << name(*overlap(die, ground).status) << ", closer than 1/8: " << *closer_than(die, ground, {1, 8}).closer
            << "\n";

  // An exact rotation; and a proof about the body where it is.
  die.pose = fathom::rigid_pose({3, 0, 0, 1}, {0, 0, mpq_class(4, 3)});
  const fathom::Body a = moved(die), b = moved(ground);
  const std::string proof = certificate_text(a, b, penetration_depth(die, ground));
  std::cout << verdict_line(fathom_check::verify(proof), "die") << "\n";
}

int main() {
  questions();
  moving();
}

//> penetrating
//> touching
//> disjoint
//> 01
//> the planes across (-1, 0, 0) separate them
//> x = 1 of A and x = 3/2 of B are close
//> 8 extreme points of 8
//> disjoint 0
//> touching 0
//> penetrating 0.125
//> penetrating, closer than 1/8: 1
//> s VERIFIED penetrating depth_squared=1/36 optima=1 die
