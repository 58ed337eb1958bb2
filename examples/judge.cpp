// SPDX-License-Identifier: GPL-3.0-or-later
// Is an implementation's answer right, and if not, how wrong is it? Unit cubes, the second moved by
// 0.4; and cylinders of radius 1 side by side, whose axes are 1.8 apart.
#include <fathom/judge.hpp>
#include <fathom/numbers.hpp>
#include <fathom/shape.hpp>
#include <iostream>

using Cube = std::vector<fathom::Triple>;

Cube cube(double x) {
  Cube corners;
  for (int i = 0; i < 8; ++i) corners.push_back({x + (i & 1), double(i >> 1 & 1), double(i >> 2)});
  return corners;
}

std::vector<fathom::Point> exact(const Cube& cube) {
  std::vector<fathom::Point> points;
  for (const auto& [x, y, z] : cube)
    points.push_back({fathom::exact_value(x), fathom::exact_value(y), fathom::exact_value(z)});
  return points;
}

void tell(const fathom::Judgement& judgement) {
  std::cout << fathom::name(judgement.verdict) << ": " << judgement.sentence << "\n";
  if (judgement.accuracy) std::cout << "  " << fathom::name(*judgement.accuracy) << "\n";
}

void about_cylinders() {
  const fathom::Shape one = fathom::cylinder(1, 1),
                      other = fathom::moved(one, fathom::rigid_pose({1, 0, 0, 0}, {mpq_class(9, 5), 0, 0}));
  const fathom::ShapeTruth truth = fathom::truth_about(one, other);
  fathom::Reply reply;
  reply.overlap = true;
  for (const double depth : {0.2, 0.25}) {
    reply.depth = depth;
    reply.direction = {-1, 0, 0};
    const fathom::Judgement judgement = fathom::judge(truth, reply);
    std::cout << fathom::name(judgement.verdict) << ": " << judgement.sentence << "\n";
    std::cout << "  the truth is known to within " << judgement.signed_depth->high - judgement.signed_depth->low
              << ", the separating distance of the direction is " << judgement.separating_distance->low << "\n";
  }
}

int main() {
  fathom::Reply reply;  // what the implementation answered
  reply.overlap = true;
  reply.depth = 1.0392;
  reply.direction = {-1, 0, 0};
  tell(fathom::judge(cube(0), cube(0.4), reply));

  // The same for points in exact numbers, and for several replies about one pair: here of an
  // implementation in binary32.
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
    std::cout << "  passes " << fathom::passes(judgement.verdict) << ", fails " << fathom::fails(judgement.verdict)
              << ", too shallow " << (judgement.verdict == fathom::verdict_named("too-shallow")) << "; in "
              << fathom::name(precision) << "\n";
  }
  about_cylinders();
}

//> too-deep: too deep by 0.4392: 1.0392 is claimed, the depth is 0.6; inconsistent: the plane across its direction is at 0.6, not at 1.0392
//> pass: right: 0.6 is claimed, the depth is 0.5999999940395355 (correctly rounded)
//>   correctly rounded
//>   passes 1, fails 0, too shallow 0; in binary32
//> too-shallow: too shallow by 0.01: 0.59 is claimed, the depth is 0.5999999940395355; not separating: 0.01 of overlap is left along its direction; inconsistent: the plane across its direction is at 0.5999999940395355, not at 0.59
//>   passes 0, fails 1, too shallow 1; in binary32
//> pass: right: 0.2 is claimed, the depth is 0.2 (correctly rounded)
//>   the truth is known to within 2.77556e-17, the separating distance of the direction is 0.2
//> too-deep: too deep by 0.05: 0.25 is claimed, the depth is 0.2; inconsistent: the plane across its direction is at 0.2, not at 0.25
//>   the truth is known to within 9.66338e-13, the separating distance of the direction is 0.2
