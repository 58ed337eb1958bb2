// SPDX-License-Identifier: GPL-3.0-or-later
// fathom cases --from-fcl FILE
#pragma once

#include <string>

#include "cli/io/output.hpp"

namespace fathom::cli {

/// Prints each failure in the text of FCL's exceptions as a case; "-" is the standard input. Throws InputError if there is none, or a bad
/// one.
ExitCode print_fcl_cases(const std::string& path);

}  // namespace fathom::cli
