// SPDX-License-Identifier: GPL-3.0-or-later
// What the process tells its caller when it ends.
#pragma once

namespace fathom::cli {

/// Exit codes; 1 (a verdict failed, a certificate was refused) and 4 (incomplete) belong to commands that judge.
/// In a stream the largest that occurred counts.
enum ExitCode : int {
  fine = 0,
  bad_input = 2,       ///< usage; or input malformed, missing, unreadable, empty, a directory
  internal_error = 3,  ///< a fault of fathom itself, or output cannot be written
  interrupted = 130,   ///< Ctrl-C
};

}  // namespace fathom::cli
