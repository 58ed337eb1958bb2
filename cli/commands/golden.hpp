// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `fathom golden` that one process and many share.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cli/args/golden_arguments.hpp"
#include "cli/io/output.hpp"
#include "verify/golden/release/release.hpp"

namespace fathom::cli {

/// Does `work` for the request that the words make. Says what is wrong with the words only if
/// `says_usage`, and what is wrong with folders and files always. Lets other exceptions of `work`
/// pass.
ExitCode carry_out_golden(const std::vector<std::string>& words, bool says_usage,
                          const std::function<ExitCode(const GoldenRequest&)>& work);

/// The shards of the request's part: i, i + n, i + 2 n, ...
std::vector<std::size_t> in_part(const std::vector<std::size_t>& shards, const GoldenRequest& request);

/// Verifies and prints what was found. `elsewhere`: see VerifyOptions. Throws FileError if the
/// folder cannot be read, Interrupted.
ExitCode verify_golden(
    const GoldenRequest& request,
    std::function<void(const std::vector<golden::ShardPlan>&, const golden::TakeShard&)> elsewhere = {});

/// Prints the export, and on standard error how many records it holds and why others do not fit.
/// Throws FolderError, FileError, InputError, OutputError, Interrupted.
ExitCode export_golden(const GoldenRequest& request);

}  // namespace fathom::cli
