// SPDX-License-Identifier: GPL-3.0-or-later
// The part of `fathom certify` that one process and many share.
#pragma once

#include <string>
#include <vector>

#include "cli/args/request.hpp"
#include "cli/io/output.hpp"
#include "verify/harness/examiner.hpp"
#include "verify/harness/outcome.hpp"

namespace fathom::cli {

/// Who examines cases instead of threads of this process.
struct ExaminersElsewhere {
  unsigned count = 0;  ///< cases at once; 0: nobody does
  /// Examines a case, all lengths times 2^exponent, with a subject whose hello must be `hello`.
  /// Called from as many threads. Throws as Examiner::examine.
  std::function<harness::Outcome(const Case&, long exponent, const std::string& hello)> examine = {};
};

/// A run from the hello to the exit code. Throws as run_certify.
ExitCode certify(const Request& request, const ExaminersElsewhere& elsewhere);

/// The shell command of the request's subject. Throws InputError if its adapter is unknown or not
/// built.
harness::SubjectCommand subject_of(const CertifyRequest& certify);

/// What examiners of the request are set to; nobody hears of what no case is to blame for.
harness::Settings examiner_settings(const CertifyRequest& certify);

}  // namespace fathom::cli
