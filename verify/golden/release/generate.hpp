// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a level, a seed, a folder.
// Output  the release in that folder, or the requested part of its shards. Complete shards in it are kept, so a run
//         that was interrupted or killed goes on where it stopped. The bytes do not depend on the number of threads or processes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fathom/monitor.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::golden {

/// Progress, in base cases.
struct Done {
  std::size_t recipes = 0, of = 0;
  std::string shard;  ///< the one being written
};

struct GenerateOptions {
  Level level = Level::L0;
  std::uint64_t seed = 1;
  std::filesystem::path folder;
  unsigned jobs = 0;                        ///< threads; 0: as many as there are cores
  Monitor* monitor = nullptr;               ///< asked from all threads whether to stop
  std::function<void(const Done&)> report;  ///< called from one thread at a time
};

class Generation {
 public:
  /// Reads the folder, or makes it. Throws FolderError if it holds anything else than this release, FileError.
  explicit Generation(GenerateOptions options);

  [[nodiscard]] const std::vector<ShardPlan>& shards() const { return shards_; }
  /// Returns the numbers of the shards that are absent or damaged, ascending. Reads the files. Throws as the constructor does.
  [[nodiscard]] std::vector<std::size_t> unfinished() const;
  /// Makes these shards, in this order. Throws FileError, Interrupted; std::logic_error if a record does not hold against its proof. Shards
  /// that were finished before stay; of the others nothing does.
  void make(std::span<const std::size_t> numbers) const;
  /// Writes the pages that complete the release. Throws FolderError if a shard is missing, FileError.
  void close() const;

 private:
  GenerateOptions options_;
  std::vector<ShardPlan> shards_;
};

}  // namespace fathom::golden
