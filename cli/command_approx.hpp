// SPDX-License-Identifier: GPL-3.0-or-later
// Answers within a factor of 1 + delta, as `approx` and `width --delta` give them: to a single case, or to a stream.
#pragma once

#include "cli/exit_code.hpp"
#include "cli/request.hpp"
#include "reference/files/body.hpp"

namespace fathom::cli {

/// request.delta must be set. These throw as the commands do.
ExitCode approximate_single(const Request& request, const Case& single);
ExitCode approximate_stream(const Request& request);

}  // namespace fathom::cli
