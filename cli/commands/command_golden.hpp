// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `fathom golden` that one process and many share.
#pragma once

#include <cstddef>
#include <vector>

#include "cli/args/golden_arguments.hpp"
#include "cli/io/exit_code.hpp"
#include "verify/golden/release/verify.hpp"

namespace fathom::cli {

/// The shards of the request's part: i, i + n, i + 2 n, ...
std::vector<std::size_t> in_part(const std::vector<std::size_t>& shards, const GoldenRequest& request);

/// Verifies and prints what was found. `elsewhere`: see VerifyOptions. Throws FileError if the folder cannot be read, Interrupted.
ExitCode verify_golden(const GoldenRequest& request,
                       std::function<void(const std::vector<golden::ShardPlan>&, const golden::TakeShard&)> elsewhere = {});

}  // namespace fathom::cli
