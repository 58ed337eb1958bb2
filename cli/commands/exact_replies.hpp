// SPDX-License-Identifier: GPL-3.0-or-later
// The replies of `depth` and of `width`.
#pragma once

#include "cli/commands/replies.hpp"

namespace fathom::cli {

/// Answers with the method of the request, and with a certificate if it asks for one. `request` must outlive the replies. Throws InputError
/// if certificates cannot be written where they should go.
Replies exact_replies(const Request& request);

}  // namespace fathom::cli
