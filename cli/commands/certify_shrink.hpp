// SPDX-License-Identifier: GPL-3.0-or-later
// fathom certify --shrink: one failing case of each verdict, made small.
#pragma once

#include "cli/commands/certify_collector.hpp"
#include "verify/harness/examiner.hpp"

namespace fathom::cli {

/// Reduces, for each verdict and variant that failed, the smallest failing case; writes it to disk at each step. Prints the case,
/// the files, and the snippet; with --json the files alone, on standard error. Throws Interrupted, SubjectError, InputError.
void shrink_failures(const Request& request, harness::Examiner& examiner, Collector& found);

}  // namespace fathom::cli
