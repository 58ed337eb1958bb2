// SPDX-License-Identifier: GPL-3.0-or-later
// Is an implementation's answer right, and if not, how wrong is it? Unit cubes, the second moved by 0.4.
#include <fathom/judge.hpp>
#include <fathom/numbers.hpp>
#include <iostream>

using Cube = std::vector<fathom::Triple>;

Cube cube(double x) {
  Cube corners;
  for (int i = 0; i < 8; ++i) corners.push_back({x + (i & 1), double(i >> 1 & 1), double(i >> 2)});
  return corners;
}

std::vector<fathom::Point> exact(const Cube& cube) {
  std::vector<fathom::Point> points;
  for (const auto& [x, y, z] : cube) points.push_back({fathom::exact_value(x), fathom::exact_value(y), fathom::exact_value(z)});
  return points;
}

void tell(const fathom::Judgement& judgement) {
  std::cout << fathom::name(judgement.verdict) << ": " << judgement.sentence << "\n";
  if (judgement.accuracy) std::cout << "  " << fathom::name(*judgement.accuracy) << "\n";
}

int main() {
  fathom::Reply reply;  // what the implementation answered
  reply.overlap = true;
  reply.depth = 1.0392;
  reply.direction = {-1, 0, 0};
  tell(fathom::judge(cube(0), cube(0.4), reply));

  // The same for points in exact numbers, and for several replies about one pair: here of an implementation in binary32.
  const fathom::Precision precision = fathom::Precision::binary32;
  const auto a = fathom::seen(exact(cube(0)), precision), b = fathom::seen(exact(cube(0.4)), precision);
  const fathom::Truth truth = fathom::truth_about(*a, *b);
  fathom::Conventions ours;  // depths below 0, and directions that move B
  ours.depth = fathom::Conventions::Sign::negative;
  ours.moves = fathom::Conventions::Body::b;
  for (const float depth : {-0.6F, -0.59F}) {
    reply.depth = depth;
    reply.direction = {1, 0, 0};
    const fathom::Judgement judgement = fathom::judge(truth, reply, ours, precision);
    tell(judgement);
    std::cout << "  passes " << fathom::passes(judgement.verdict) << ", fails " << fathom::fails(judgement.verdict) << ", too shallow "
              << (judgement.verdict == fathom::verdict_named("too-shallow")) << "; in " << fathom::name(precision) << "\n";
  }
}

//> too-deep: too deep by 0.4392: 1.0392 is claimed, the depth is 0.6; inconsistent: the plane across its direction is at 0.6, not at 1.0392
//> pass: right: 0.6 is claimed, the depth is 0.5999999940395355 (correctly rounded)
//>   correctly rounded
//>   passes 1, fails 0, too shallow 0; in binary32
//> too-shallow: too shallow by 0.01: 0.59 is claimed, the depth is 0.5999999940395355; not separating: 0.01 of overlap is left along its direction; inconsistent: the plane across its direction is at 0.5999999940395355, not at 0.59
//>   passes 0, fails 1, too shallow 1; in binary32
