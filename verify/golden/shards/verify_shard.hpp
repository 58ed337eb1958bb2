// SPDX-License-Identifier: GPL-3.0-or-later
// One shard of a release, read as three streams in step and proved record by record, on all threads of the caller's arena.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/shards/manifest.hpp"

namespace fathom::golden {

/// Why a release is not accepted, and where.
struct Refusal {
  std::string place;  ///< a file's name, with ":" and a line where there is one
  std::string reason;
};

struct ShardOptions {
  std::vector<Method> methods;   ///< that have to give every record again, beside its proof
  Monitor* monitor = nullptr;    ///< stops all threads
  std::function<void()> proved;  ///< called after each record from one thread at a time; may be empty
};

/// Returns the first fault, in the order of the records, or nullopt if every record is proved, given again by each of the methods, and
/// stands where the plan says, the certificates and the CSV belong to exactly these records, and counts and sums are those of the
/// page. Memory is bounded by a few dozen records for each thread. Throws Interrupted.
std::optional<Refusal> refusal_of_shard(const std::filesystem::path& folder, const ShardPlan& shard, const Manifest& manifest,
                                        const ShardOptions& options);

}  // namespace fathom::golden
