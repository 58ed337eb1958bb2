// SPDX-License-Identifier: GPL-3.0-or-later
// The replies of `depth` and of `width`.
#pragma once

#include "cli/commands/replies.hpp"
#include "fathom/signed_depth.hpp"
#include "fathom/union.hpp"

namespace fathom::cli {

/// How the request wants depths to be found; of shapes too.
Options options_of(const Request& request, Monitor& monitor, Workspace& workspace);
SignedDepthOptions shape_options_of(const Request& request, Monitor& monitor, Workspace& workspace);

/// Returns the depth of the bodies of a case as unions of pieces. Throws InputError for pieces without an interior.
UnionDepth union_depth_of(const Case& single, Monitor& monitor);

/// Answers with the method of the request, and with a certificate if it asks for one. `request` must outlive the replies. Throws InputError
/// if certificates cannot be written where they should go.
Replies exact_replies(const Request& request);

}  // namespace fathom::cli
