// SPDX-License-Identifier: GPL-3.0-or-later
// The files of one shard: written as its records arrive, in their order; and read again, not trusted.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {

class ShardWriter {
 public:
  /// Removes the shard's old page, if there is one: from then on the shard is unfinished. Throws FileError, here and below.
  ShardWriter(std::filesystem::path folder, const ShardPlan& shard, std::uint64_t seed);

  void add(const Record& record);

  /// Syncs all files to disk, then renames them, then writes the page. Until the page is there, the shard is unfinished.
  void finish();

 private:
  void write_csv(std::string_view text);
  void rename_all();

  std::filesystem::path folder_;
  Manifest manifest_;
  std::vector<std::unique_ptr<ZstdWriter>> writers_;  // in the order of the suffixes
};

// ---- verification ----

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
/// page. Runs on all threads of the caller's arena; memory is bounded by a few dozen records for each. Throws Interrupted.
std::optional<Refusal> refusal_of_shard(const std::filesystem::path& folder, const ShardPlan& shard, const Manifest& manifest,
                                        const ShardOptions& options);

}  // namespace fathom::golden
