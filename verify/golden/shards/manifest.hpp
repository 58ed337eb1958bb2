// SPDX-License-Identifier: GPL-3.0-or-later
// Manifests: the files of a shard, listed in the page golden-L0-0000.json beside it and in dataset.json. The page is written last, so a
// shard is complete if its page is there.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/digest/sha256.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::golden {

/// The files of a shard, by the ends of their names: records, certificates one after another, and of polytopes CSV, as a
/// row has two lists of points for the bodies.
inline constexpr std::array<std::string_view, 3> shard_suffixes = {".jsonl.zst", ".cert.zst", ".csv.zst"};
/// Those of a shard of this level: the first two, or all.
std::span<const std::string_view> suffixes_of(Level level);
inline constexpr std::string_view manifest_suffix = ".json";

struct ShardFile {
  std::string name;
  digest::Digest file;     ///< as stored
  digest::Digest content;  ///< decompressed: the same for every version of libzstd
  friend bool operator==(const ShardFile&, const ShardFile&) = default;
};

struct Manifest {
  std::string name;
  Level level = Level::L0;
  std::string version;  ///< of the data
  std::uint64_t seed = 0;
  std::size_t recipes = 0, records = 0;
  std::string zstd;              ///< the version of libzstd that compressed it
  std::vector<ShardFile> files;  ///< in the order of the suffixes
  friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// JSON, schemas/shard.schema.json; ends with a line feed.
std::string manifest_text(const Manifest& manifest);

/// Returns nullopt unless `text` is, byte for byte, what manifest_text makes of it.
std::optional<Manifest> parse_manifest(std::string_view text);

/// The same as a value, for the page that holds several.
nlohmann::ordered_json manifest_json(const Manifest& manifest);

/// Throws std::exception if a field is missing or of another kind; ignores unknown fields.
Manifest manifest_of(const nlohmann::ordered_json& json);

/// Returns why `manifest` is not that of the planned shard, made from `seed` by this version: a sentence, or nullopt.
std::optional<std::string> not_of_plan(const Manifest& manifest, const ShardPlan& shard, std::uint64_t seed);

enum class ShardState { absent, damaged, finished };

/// Returns whether the shard is in the folder with its page, and its files are those that the page describes. Throws FolderError if the
/// page is about another seed or version, FileError.
ShardState state_of(const std::filesystem::path& folder, const ShardPlan& shard, std::uint64_t seed);

}  // namespace fathom::golden
