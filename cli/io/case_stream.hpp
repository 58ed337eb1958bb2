// SPDX-License-Identifier: GPL-3.0-or-later
// What all commands that answer streams of cases share.
#pragma once

#include <functional>
#include <string>

#include "cli/io/exit_code.hpp"
#include "cli/io/progress.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

/// What a command does with the cases of a stream.
struct StreamWork {
  /// Answers one case and prints the answer. May throw anything.
  std::function<void(const Case&, Progress&)> answer;
  /// Returns the result line of a case without an answer; if not set, the sentence goes to standard error.
  std::function<std::string(const CaseItem&, const std::string& sentence)> error_line;
  /// Printed before all results, unless empty.
  std::string header;
  /// Whether B is ignored.
  bool one_body = false;
};

/// Answers each case of the stream called `input` before the next one is read. A bad case gets its error and counts in the exit code, and
/// the stream goes on. Notes the first case with points that are not extreme on standard error, and a count of others at the end. A stream
/// without any case is an error. Throws InputError if the stream cannot be read, OutputError, Interrupted.
ExitCode for_each_case(const std::string& input, const StreamWork& work);

}  // namespace fathom::cli
