// SPDX-License-Identifier: GPL-3.0-or-later
// A stream of cases, one after another: what the commands that answer streams have in common.
#pragma once

#include <functional>
#include <string>

#include "cli/exit_code.hpp"
#include "cli/progress.hpp"
#include "reference/files/cases.hpp"

namespace fathom::cli {

/// What a command does with the cases of a stream.
struct StreamWork {
  /// Answers one case and prints the answer. Tells whether convex hulls were taken of points that are not all extreme: the end says of
  /// how many cases. May throw anything.
  std::function<bool(const Case&, Progress&)> answer;
  /// What stands among the results for a case that has none; without it, the sentence goes to standard error.
  std::function<std::string(const CaseItem&, const std::string& sentence)> error_line;
  /// Stands before all results; empty: nothing.
  std::string header;
};

/// Answers each case of the stream called `input` before the next one is read. A bad case gets its error and the stream goes on; the
/// exit code tells. A stream without any case is an error.
/// Throws InputError when the stream cannot be read, OutputError, Interrupted.
ExitCode for_each_case(const std::string& input, const StreamWork& work);

}  // namespace fathom::cli
