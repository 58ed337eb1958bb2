// SPDX-License-Identifier: GPL-3.0-or-later
// What the process tells its caller when it ends.
#pragma once

namespace fathom::cli {

/// Exit codes; a stream ends with the largest that occurred.
enum ExitCode : int {
  fine = 0,
  judged_wrong = 1,    ///< a verdict failed, a certificate was refused
  bad_input = 2,       ///< usage; or input malformed, missing, unreadable, empty, a directory
  internal_error = 3,  ///< a fault of fathom itself, or output cannot be written
  incomplete = 4,      ///< not every case could be put to the subject
  interrupted = 130,   ///< Ctrl-C
};

}  // namespace fathom::cli
