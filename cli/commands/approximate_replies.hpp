// SPDX-License-Identifier: GPL-3.0-or-later
// The replies of `approx` and of `width --delta`.
#pragma once

#include "cli/commands/replies.hpp"

namespace fathom::cli {

/// request.delta must be set, and `request` must outlive the replies.
Replies approximate_replies(const Request& request);

}  // namespace fathom::cli
