// SPDX-License-Identifier: GPL-3.0-or-later
// Is an answer about round or curved shapes right? Two cylinders of radius 1 side by side, whose axes are 1.8 apart.
#include <fathom/judge.hpp>
#include <fathom/shape.hpp>
#include <iostream>

int main() {
  const fathom::Shape one = fathom::cylinder(1, 1), other = fathom::moved(one, fathom::rigid_pose({1, 0, 0, 0}, {mpq_class(9, 5), 0, 0}));
  const fathom::ShapeTruth truth = fathom::truth_about(one, other);
  fathom::Reply reply;
  reply.overlap = true;
  for (const double depth : {0.2, 0.25}) {
    reply.depth = depth;
    reply.direction = {-1, 0, 0};
    const fathom::Judgement judgement = fathom::judge(truth, reply);
    std::cout << fathom::name(judgement.verdict) << ": " << judgement.sentence << "\n";
    std::cout << "  the truth is known to within " << judgement.signed_depth->high - judgement.signed_depth->low
              << ", the price of the direction is " << judgement.price->low << "\n";
  }
}

//> pass: right: 0.2 is claimed, the depth is 0.2 (correctly rounded)
//>   the truth is known to within 2.77556e-17, the price of the direction is 0.2
//> too-deep: too deep by 0.05: 0.25 is claimed, the depth is 0.2; inconsistent: the plane across its direction is at 0.2, not at 0.25
//>   the truth is known to within 9.66338e-13, the price of the direction is 0.2
