// SPDX-License-Identifier: GPL-3.0-or-later
// One function per command, and the two ways in which each of them answers: a single case, or a stream.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/args/request.hpp"
#include "cli/io/exit_code.hpp"
#include "reference/files/body.hpp"

namespace fathom::cli {

class Progress;
struct Answer;

/// These throw InputError, OutputError, Interrupted; any other exception is an internal error.
ExitCode run_depth(const Request& request);
ExitCode run_width(const Request& request);
ExitCode run_approx(const Request& request);
ExitCode run_ray(const Request& request);
ExitCode run_metric(const Request& request);
ExitCode run_study(const Request& request);
ExitCode run_cases(const Request& request);
ExitCode run_certify(const Request& request);

/// Takes the words behind "check"; prints itself what is wrong with them.
ExitCode run_check(std::vector<std::string> words);

/// Takes the words behind "golden".
ExitCode run_golden(const std::vector<std::string>& words);

/// What a command computes for one case.
using Solve = std::function<Depth(const Case&, const Options&)>;

/// How a case is answered: see answer_by and approximating.
using Answering = std::function<Answer(const Case&, Progress&)>;

/// Prints the answer to one case.
ExitCode answer_single(const Request& request, Case single, const Answering& answering);

/// Prints the answer to each case of the stream that the only input names, before the next case is read. A bad case gets an error line and
/// counts in the exit code, and the stream goes on. A stream without any case is an error.
ExitCode answer_stream(const Request& request, const Answering& answering);

/// Returns the message for `error`, which no input is to blame for.
std::string fault_text(const std::exception& error);

}  // namespace fathom::cli
