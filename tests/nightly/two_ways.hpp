// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of fathom-two-ways: a random stream of cases through two ways, for as long as
// one likes.
#pragma once

#include "verify/harness/two_ways.hpp"

namespace fathom::nightly {

/// Returns the exit code: 0 the ways agree; 1 they differ, and the case was kept; 2 wrong
/// arguments; 3 an error; 130 interrupted.
int two_ways(int argc, char** argv, const harness::Solver& x, const harness::Solver& y);

}  // namespace fathom::nightly
