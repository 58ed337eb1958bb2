// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/args/request.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {

/// fathom certify --claims FILE: judges what was published about pairs of bodies. Returns 1 if a claim is wrong. Throws InputError if the
/// file cannot be read, OutputError, Interrupted.
ExitCode judge_claims(const Request& request);

}  // namespace fathom::cli
