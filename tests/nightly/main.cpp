// SPDX-License-Identifier: GPL-3.0-or-later
// fathom-two-ways: what users get, with its proof checked, against AGHRS's pipeline.
#include "tests/nightly/two_ways.hpp"

int main(int argc, char** argv) {
  using namespace fathom;
  return nightly::two_ways(argc, argv, harness::solver_with_proof(), harness::solver_by(Method::exact));
}
