// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the files of one shard as its records arrive, in their order.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "verify/golden/io/zstd_file.hpp"
#include "verify/golden/records/record.hpp"
#include "verify/golden/shards/manifest.hpp"

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

}  // namespace fathom::golden
