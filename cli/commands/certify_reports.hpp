// SPDX-License-Identifier: GPL-3.0-or-later
// What is written at the end of a run of `fathom certify`, and its exit code.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/certify_results.hpp"
#include "cli/io/output.hpp"
#include "verify/harness/report/expect_fail.hpp"

namespace fathom::cli {

/// Throws InputError if one of the requested files and folders cannot be written. Makes folders.
void probe_reports(const CertifyRequest& certify);

/// Returns the list that --write-expect-fail replaces, to keep its comments; an empty one if there is none. Throws InputError.
harness::ExpectedFailures earlier_list(const CertifyRequest& certify);

/// Names of files, by index of the outcome.
using CertificateNames = std::map<std::size_t, std::string>;
/// Writes one for each failing case, if requested. Throws OutputError, InputError, Interrupted.
CertificateNames write_certificates(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found);

/// Writes JUnit and the page, if requested. `cut_short`: why cases are missing; empty if none is. Throws OutputError, InputError.
void write_reports(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found,
                   const std::optional<harness::ExpectedFailures::Check>& known, const CertificateNames& certificates,
                   const std::string& cut_short);

/// Writes the list of known failures, if requested. Throws OutputError, InputError.
void write_list(const CertifyRequest& certify, const harness::SubjectInfo& info, const Collector& found,
                const harness::ExpectedFailures& earlier);

/// Returns where to find more than in the table: the reports that were written, and the options for the others.
std::vector<std::string> where_to_look(const CertifyRequest& certify);

/// Returns the exit code by the verdicts alone: fine, judged_wrong, or incomplete if nothing was judged. Prints where run and list
/// disagree.
ExitCode code_of(const CertifyRequest& certify, Collector& found, const std::optional<harness::ExpectedFailures::Check>& known);

}  // namespace fathom::cli
