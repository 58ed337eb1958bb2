// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-two-ways: what users get, with its proof checked, against AGHRS's pipeline; of unions
// against their parts.
#include "tests/nightly/two_ways.hpp"
#include "tests/nightly/unions_by_parts.hpp"

int main(int argc, char** argv) {
  return fathom::nightly::two_ways(argc, argv, fathom::harness::solver_with_proof(), fathom::nightly::second_solver());
}
