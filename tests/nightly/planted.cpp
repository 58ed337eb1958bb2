// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-two-ways with a difference planted: the second way finds deep overlaps of bodies of six points or more a little too deep. So the
// tests see that a difference is found, made smaller and kept.
#include "tests/nightly/two_ways.hpp"

int main(int argc, char** argv) {
  using namespace fathom;
  harness::Solver wrong = harness::solver_by(Method::exact);
  wrong.depth = [right = wrong.depth](const Case& pair, Monitor* monitor) {
    Depth depth = right(pair, monitor);
    if (auto* penetration = std::get_if<Penetration>(&depth.outcome); penetration && pair.a.points.size() > 5)
      penetration->optima.front().support *= mpq_class(1'000'001, 1'000'000);
    return depth;
  };
  return nightly::two_ways(argc, argv, harness::solver_with_proof(), wrong);
}
