// SPDX-License-Identifier: GPL-3.0-or-later
// A stream of cases, one after another: what the commands that answer streams have in common.
#pragma once

#include <functional>
#include <string>

#include "cli/io/exit_code.hpp"
#include "cli/io/progress.hpp"
#include "reference/files/cases.hpp"

namespace fathom::cli {

/// What a command does with the cases of a stream.
struct StreamWork {
  /// Answers one case and prints the answer. May throw anything.
  std::function<void(const Case&, Progress&)> answer;
  /// What stands among the results for a case that has none; without it, the sentence goes to standard error.
  std::function<std::string(const CaseItem&, const std::string& sentence)> error_line;
  /// Stands before all results; empty: nothing.
  std::string header;
  /// Whether B is not looked at.
  bool one_body = false;
};

/// Answers each case of the stream called `input` before the next one is read. A bad case gets its error and the stream goes on; the
/// exit code tells. The first case with points that are not extreme is told on standard error. A stream without any case is an error.
/// Throws InputError when the stream cannot be read, OutputError, Interrupted.
ExitCode for_each_case(const std::string& input, const StreamWork& work);

}  // namespace fathom::cli
