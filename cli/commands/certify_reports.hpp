// SPDX-License-Identifier: GPL-3.0-or-later
// What is written at the end of a run of `fathom certify`, and what the run comes to.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/certify_collector.hpp"
#include "cli/io/exit_code.hpp"
#include "verify/harness/report/expect_fail.hpp"

namespace fathom::cli {

/// Throws InputError if one of the files and folders that are asked for cannot be written. Folders are made.
void probe_reports(const CertifyRequest& certify);

/// The list that --write-expect-fail would replace, to keep its comments; an empty one if there is none. Throws InputError.
harness::ExpectedFailures earlier_list(const CertifyRequest& certify);

/// By index of the outcome, the file's name.
using CertificateNames = std::map<std::size_t, std::string>;
/// One for each failing case, if they are asked for. Throws OutputError, InputError, Interrupted.
CertificateNames write_certificates(const CertifyRequest& certify, Collector& found);

/// Writes JUnit and the page, as asked for. `cut_short`: why cases are missing; empty if none is. Throws OutputError, InputError.
void write_reports(const CertifyRequest& certify, const harness::SubjectInfo& info, Collector& found,
                   const std::optional<harness::ExpectedFailures::Check>& known, const CertificateNames& certificates,
                   const std::string& cut_short);

/// Writes the list of known failures, if it is asked for. Throws OutputError, InputError.
void write_list(const CertifyRequest& certify, const harness::SubjectInfo& info, const Collector& found,
                const harness::ExpectedFailures& earlier);

/// Where more is to be found than in the table: the reports that there are, and the options for those that there are not.
std::vector<std::string> where_to_look(const CertifyRequest& certify);

/// What verdicts alone say: fine, judged_wrong, or incomplete where nothing was judged. Tells where run and list disagree.
ExitCode code_of(const CertifyRequest& certify, Collector& found, const std::optional<harness::ExpectedFailures::Check>& known);

}  // namespace fathom::cli
