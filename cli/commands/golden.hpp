// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `fathom golden` that runs in one process and runs under MPI share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/io/output.hpp"
#include "fathom/depth.hpp"
#include "verify/golden/release/release.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::cli {

struct GenerateRequest {
  explicit GenerateRequest(const Given& given);

  golden::Level level;
  std::uint64_t seed;
  std::string folder;
  unsigned jobs;            ///< 0: as many as there are cores
  bool is_part;             ///< only every `parts`-th shard
  std::size_t part, parts;  ///< 1 <= part <= parts
};

struct VerifyRequest {
  explicit VerifyRequest(const Given& given);

  std::string folder;
  unsigned jobs;                ///< 0: as many as there are cores
  std::vector<Method> methods;  ///< compute every record again by these too
  bool state;                   ///< write the page that states the results
};

/// Calls `work` for the task that the words name. Prints errors in the words only if `says_usage`,
/// and errors in folders and files always. Other exceptions of `work` pass through.
ExitCode carry_out_golden(const std::vector<std::string>& words, bool says_usage,
                          const std::function<ExitCode(const Given&)>& work);

/// Returns the shards of the request's part: i, i + n, i + 2 n, ...
std::vector<std::size_t> in_part(const std::vector<std::size_t>& shards, const GenerateRequest& request);

/// Verifies the data and prints the result. `elsewhere`: see VerifyOptions. Throws FileError if the
/// folder cannot be read, Interrupted.
ExitCode verify_golden(
    const VerifyRequest& request,
    std::function<void(const std::vector<golden::ShardPlan>&, const golden::TakeShard&)> elsewhere = {});

/// Prints the export, and on standard error its number of records and the reasons why others were
/// omitted. Throws FolderError, FileError, InputError, OutputError, Interrupted.
ExitCode export_golden(const Given& given);

}  // namespace fathom::cli
