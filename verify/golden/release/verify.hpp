// SPDX-License-Identifier: GPL-3.0-or-later
// Input   the folder of a release, not trusted.
// Output  what is wrong with it. Refusal is the default: names, sums, pages, counts, every certificate and every value are checked, and by
//         whom it is said to have been computed again.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/release/release.hpp"
#include "verify/golden/shards/plan.hpp"
#include "verify/golden/shards/shard.hpp"

namespace fathom::golden {

/// What was found in one shard.
struct ShardResult {
  std::size_t records = 0;  ///< that were proved
  std::optional<Refusal> refusal;
};

/// Takes the result of the shard of that number, in order. Returns whether it wants more.
using TakeShard = std::function<bool(std::size_t shard, ShardResult result)>;

struct VerifyOptions {
  std::vector<Method> methods;                                      ///< compute every record again by each of these, beside its proof
  unsigned jobs = 0;                                                ///< threads; 0: as many as there are cores
  Monitor* monitor = nullptr;                                       ///< asked from all threads whether to stop
  std::function<void(std::size_t records, std::size_t of)> report;  ///< called from one thread at a time
  /// If set, it has the shards proved, by ShardVerifier, and passes on the results: all of `shards`, or those before the first refusal.
  std::function<void(const std::vector<ShardPlan>& shards, const TakeShard& take)> elsewhere;
};

struct Verified {
  Level level = Level::L0;
  std::string version;
  std::uint64_t seed = 0;
  std::size_t shards = 0, records = 0;
  std::vector<Refusal> refusals;  ///< empty if accepted; otherwise every bad name, checksum and page, then the first bad record
};

/// Throws FileError if the folder itself cannot be read, Interrupted.
Verified verify(const std::filesystem::path& folder, const VerifyOptions& options = {});

/// Proves single shards of a release, whose pages somebody else checks.
class ShardVerifier {
 public:
  /// Throws FileError if the folder is not a release.
  ShardVerifier(std::filesystem::path folder, VerifyOptions options);
  /// Throws Interrupted.
  [[nodiscard]] ShardResult verify(std::size_t shard) const;

 private:
  std::filesystem::path folder_;
  VerifyOptions options_;
  Dataset dataset_;
  std::vector<ShardPlan> shards_;
};

/// Writes the page that says by which methods the release was computed again. Call it after verify accepted the folder with these methods.
/// Throws FileError.
void state_agreement(const std::filesystem::path& folder, const Verified& verified, const std::vector<Method>& methods);

}  // namespace fathom::golden
