// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of a release as a whole: which names belong in it, and the pages that complete it once all shards are there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/golden/shards/plan.hpp"
#include "verify/golden/shards/shard.hpp"

namespace fathom::golden {

// ---- SHA256SUMS ----

/// A line "<64 digits>  <name>" for every other file of a flat folder, sorted by name, as `sha256sum -c` reads them. So is
/// CONTENT_SHA256SUMS, of decompressed files.
inline constexpr std::string_view sums_name = "SHA256SUMS";

struct Sum {
  std::string name, sha256;
  friend bool operator==(const Sum&, const Sum&) = default;
};

/// The page. The order of `sums` does not matter.
std::string sums_text(std::vector<Sum> sums);

/// Returns nullopt unless `text` is what sums_text makes of it, and no name occurs twice.
std::optional<std::vector<Sum>> parse_sums(std::string_view text);

// ---- dataset.json: what a release holds, with counts and sums ----

inline constexpr std::string_view dataset_name = "dataset.json";
inline constexpr std::string_view contents_name = "CONTENT_SHA256SUMS";

struct Dataset {
  Level level = Level::L0;
  std::string version;  ///< of the data
  std::uint64_t seed = 0;
  std::vector<Manifest> shards;
};

std::size_t records_in(const Dataset& dataset);

/// CONTENT_SHA256SUMS: the sums of the decompressed files of all shards, as `sha256sum -c` reads them. The same for every version of
/// libzstd, where SHA256SUMS, of the files as they are stored, is not.
std::string contents_text(const Dataset& dataset);

/// JSON, schemas/dataset.schema.json; ends with a line feed.
std::string dataset_text(const Dataset& dataset);

/// Returns nullopt unless `text` is, byte for byte, what dataset_text makes of it.
std::optional<Dataset> parse_dataset(std::string_view text);

// ---- agreement.json: which methods have given every record of a release ----

/// Written after the release is complete, by who computed it again, and no part of the data: SHA256SUMS does not list it, and it says
/// itself which contents it is about.
inline constexpr std::string_view agreement_name = "agreement.json";

struct Agreement {
  std::string content_sha256;   ///< of the page CONTENT_SHA256SUMS
  std::size_t records = 0;      ///< that were computed again
  std::vector<Method> methods;  ///< each of them gave every field of every record, beside the certificates; not empty
};

/// JSON, schemas/agreement.schema.json; ends with a line feed.
std::string agreement_text(const Agreement& agreement);

/// Returns nullopt unless `text` is, byte for byte, what agreement_text makes of it.
std::optional<Agreement> parse_agreement(std::string_view text);

// ---- the folder ----

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
