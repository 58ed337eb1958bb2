// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-two-ways with differences planted: the second way finds deep overlaps of bodies of six
// points or more a little too deep, and loses one of several shortest ways out of unions of three
// pieces or more. So the tests see that a difference is found, made smaller and kept.
#include "fathom/union.hpp"
#include "tests/nightly/two_ways.hpp"
#include "tests/nightly/unions_by_parts.hpp"

int main(int argc, char** argv) {
  using namespace fathom;
  harness::Solver wrong = nightly::second_solver();
  wrong.depth = [right = wrong.depth](const Case& pair, Monitor* monitor) {
    Depth depth = right(pair, monitor);
    if (auto* penetration = std::get_if<Penetration>(&depth.outcome); penetration && pair.a.points.size() > 5)
      penetration->optima.front().support *= mpq_class(1'000'001, 1'000'000);
    return depth;
  };
  wrong.of_unions = [right = wrong.of_unions](const Case& pair, Monitor* monitor) {
    harness::UnionsFound answer = right(pair, monitor);
    if (answer.translations.size() > 1 && pieces_of(pair.b).size() > 2) answer.translations.pop_back();
    return answer;
  };
  return nightly::two_ways(argc, argv, harness::solver_with_proof(), wrong);
}
