// SPDX-License-Identifier: GPL-3.0-or-later
// What is written at the end of a run of `fathom certify`, and what the run comes to.
#pragma once

#include <optional>

#include "cli/certify_collector.hpp"
#include "cli/exit_code.hpp"
#include "verify/harness/report/expect_fail.hpp"

namespace fathom::cli {

/// Throws InputError if one of the files and folders that are asked for cannot be written. Folders are made.
void probe_reports(const CertifyRequest& certify);

/// Writes certificates, JUnit, the page and the list of known failures, as asked for. Throws OutputError, InputError, Interrupted.
void write_reports(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found,
                   const std::optional<harness::ExpectedFailures::Check>& known);

/// What verdicts alone say: fine, judged_wrong, or incomplete where nothing was judged. Tells where run and list disagree.
ExitCode code_of(const CertifyRequest& certify, Collector& found, const std::optional<harness::ExpectedFailures::Check>& known);

}  // namespace fathom::cli
