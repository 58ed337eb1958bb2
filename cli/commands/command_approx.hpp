// SPDX-License-Identifier: GPL-3.0-or-later
// Answers within a factor of 1 + delta, as `approx` and `width --delta` give them.
#pragma once

#include "cli/commands/command.hpp"

namespace fathom::cli {

/// request.delta must be set, and `request` must outlive the answering, which throws as the commands do.
Answering approximating(const Request& request);

}  // namespace fathom::cli
