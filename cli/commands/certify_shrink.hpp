// SPDX-License-Identifier: GPL-3.0-or-later
// fathom certify --shrink: one failing case of each verdict, made small; and one about which fathom itself disagrees.
#pragma once

#include <string>

#include "cli/commands/certify_results.hpp"
#include "verify/harness/examiner.hpp"
#include "verify/harness/two_ways.hpp"

namespace fathom::cli {

/// Reduces, for each verdict and variant that failed, the smallest failing case; writes it to disk at each step. Prints the names of the
/// files, one a line; with --json on standard error. Throws Interrupted, SubjectError, InputError.
void shrink_failures(const Request& request, harness::Examiner& examiner, Collector& found);

/// Reduces a case about which two ways to its truth differ, and writes it to the folder at each step. Says so on standard error. Throws
/// Interrupted, InputError.
void shrink_disagreement(const std::string& folder, const harness::Disagreement& found, Progress& progress);

}  // namespace fathom::cli
