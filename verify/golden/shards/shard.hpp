// SPDX-License-Identifier: GPL-3.0-or-later
// A shard of a release: its files, listed in its page; written, read again and proved.
//
// Manifests: the files of a shard, listed in the page golden-L0-0000.json beside it and in
// dataset.json. The page is written last, so a shard is complete if its page is there.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"
#include "reference/text/json_value.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/records/record.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::golden {

/// The files of a shard, by the ends of their names: records; certificates one after another; and,
/// for polytopes only, CSV, whose rows have a list of points for each body.
inline constexpr std::array<std::string_view, 3> shard_suffixes = {".jsonl.zst", ".cert.zst", ".csv.zst"};
/// Returns the suffixes of a shard of this level: the first two, or all.
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

/// JSON, shard.schema.json; ends with a line feed.
std::string manifest_text(const Manifest& manifest);

/// Returns nullopt unless `text` is, byte for byte, what manifest_text makes of it.
std::optional<Manifest> parse_manifest(std::string_view text);

/// The same as a value, for the page that holds several.
text::Json manifest_json(const Manifest& manifest);

/// Reads a manifest. Throws std::exception if a field is missing or of another type; ignores
/// unknown fields.
Manifest manifest_of(const text::JsonValue& json);

/// Returns a sentence if `manifest` is not that of the planned shard, made from `seed` by this
/// version; else nullopt.
std::optional<std::string> not_of_plan(const Manifest& manifest, const ShardPlan& shard, std::uint64_t seed);

enum class ShardState { absent, damaged, finished };

/// Returns whether the shard's page exists and its files are those that the page describes. Throws
/// FolderError if the page is about another seed or version, FileError.
ShardState state_of(const std::filesystem::path& folder, const ShardPlan& shard, std::uint64_t seed);

// ---- the files of a shard ----

// The files of one shard: written in the order of the records; and read again as untrusted input.

class ShardWriter {
 public:
  /// Removes the shard's old page, if there is one: from then on the shard is unfinished. Throws
  /// FileError, here and below.
  ShardWriter(std::filesystem::path folder, const ShardPlan& shard, std::uint64_t seed);

  void add(const Record& record);

  /// Syncs all files to disk, then renames them, then writes the page. Until the page is there, the
  /// shard is unfinished.
  void finish();

 private:
  void write_csv(std::string_view text);
  void rename_all();

  std::filesystem::path folder_;
  Manifest manifest_;
  std::vector<std::unique_ptr<ZstdWriter>> writers_;  // in the order of the suffixes
};

// ---- verification ----

/// The reason why a release is not accepted, and its place.
struct Refusal {
  std::string place;  ///< a file's name, with ":" and a line where there is one
  std::string reason;
};

struct ShardOptions {
  std::vector<Method> methods;   ///< methods that compute every record again, besides the proof
  Monitor* monitor = nullptr;    ///< stops all threads
  std::function<void()> proved;  ///< called after each record from one thread at a time; may be empty
};

/// Returns the first fault, in the order of the records. Returns nullopt if every record is proved,
/// agrees with each of the methods and has the planned place; the certificates and the CSV belong
/// to exactly these records; and counts and sums are those of the page. Runs on all threads of the
/// caller's arena; memory is bounded by a few dozen records for each. Throws Interrupted.
std::optional<Refusal> refusal_of_shard(const std::filesystem::path& folder, const ShardPlan& shard,
                                        const Manifest& manifest, const ShardOptions& options);

}  // namespace fathom::golden
