// SPDX-License-Identifier: GPL-3.0-or-later
// The replies of `depth` and of `width`.
#pragma once

#include "cli/commands/replies.hpp"

namespace fathom::cli {

/// Answers with the method that was asked for, and with a certificate if one was. `request` must outlive the replies.
/// Throws InputError when certificates have no place to go.
Replies exact_replies(const Request& request);

}  // namespace fathom::cli
