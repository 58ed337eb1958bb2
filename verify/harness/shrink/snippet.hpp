// SPDX-License-Identifier: GPL-3.0-or-later
// A failing case as a program to paste into a bug report or a test.                                                  [docs/certify.md]
#pragma once

#include <string>

#include "verify/harness/outcome.hpp"

namespace fathom::harness {

/// A whole C++ program that puts the case to the subject's library (libccd, FCL, Bullet, ODE: info.library) by its own calls and prints
/// what it answers; for any other library, a GoogleTest that hands the recorded answer to fathom::judge. Coordinates are C99 hex floats.
/// A comment on top tells the exact depth^2, what was claimed, the verdict, and how to compile it. `pair` is as the subject saw it.
std::string snippet(const SubjectInfo& info, const Case& pair, const Outcome& outcome);

}  // namespace fathom::harness
