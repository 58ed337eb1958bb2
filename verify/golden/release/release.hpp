// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of a release as a whole: which names belong in it, and the pages that complete it once all shards are there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/golden/shards/plan.hpp"

namespace fathom::golden {

/// The pages that are the same in every release of this version: name and content.
std::vector<std::pair<std::string, std::string>> fixed_pages();

/// The names of all files of a complete release with these shards, SHA256SUMS too; agreement.json may come on top.
std::set<std::string> release_names(const std::vector<ShardPlan>& shards);

/// Makes the folder if it is missing. Throws FolderError if it holds anything but files of this release, finished or not; FileError.
void prepare_folder(const std::filesystem::path& folder, const std::vector<ShardPlan>& shards);

/// Removes the pages that only a complete release has: dataset.json, both pages of sums, agreement.json. Throws FileError.
void open_release(const std::filesystem::path& folder);

/// Writes the fixed pages, dataset.json, CONTENT_SHA256SUMS and, last, SHA256SUMS. All shards must be there. Throws FileError.
void close_release(const std::filesystem::path& folder, Level level, std::uint64_t seed, const std::vector<ShardPlan>& shards);

}  // namespace fathom::golden
