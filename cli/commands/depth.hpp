// SPDX-License-Identifier: GPL-3.0-or-later
// The replies of `depth` and of `width`.
#pragma once

#include "cli/commands/replies.hpp"
#include "cli/output/answer_output.hpp"

namespace fathom::cli {

/// How the request wants depths to be found.
Question question_of(const Request& request, Monitor& monitor, Workspace& workspace);

/// Returns the answer to a case, without its certificate. Throws InputError if the request asks for
/// what bodies of these kinds do not have, and for pieces without an interior. A search that is
/// interrupted answers between which bounds the depth lies.
AnsweredCase answered_by(const AskedCase& asked, const Request& request, const Question& question);

/// Answers with the method of the request, and with a certificate if it asks for one. `request`
/// must outlive the replies. Throws InputError if certificates cannot be written where they should
/// go.
Replies exact_replies(const Request& request);

}  // namespace fathom::cli
