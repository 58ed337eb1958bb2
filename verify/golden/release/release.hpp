// SPDX-License-Identifier: GPL-3.0-or-later
// The folder of a release as a whole: the names of its files, and the pages that complete it after
// all shards.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fathom/depth.hpp"
#include "fathom/monitor.hpp"
#include "verify/golden/shards/plan.hpp"
#include "verify/golden/shards/shard.hpp"

namespace fathom::golden {

// ---- SHA256SUMS ----

/// A line "<64 digits>  <name>" for every other file of a flat folder, sorted by name, as
///                      `sha256sum -c` reads them. So is CONTENT_SHA256SUMS, of decompressed files.
inline constexpr std::string_view sums_name = "SHA256SUMS";

struct Sum {
  std::string name, sha256;
  friend bool operator==(const Sum&, const Sum&) = default;
};

/// Returns the page. The order of `sums` does not matter.
std::string sums_text(std::vector<Sum> sums);

/// Returns the sums; nullopt unless sums_text makes the same text of them, and no name occurs
/// twice.
std::optional<std::vector<Sum>> parse_sums(std::string_view text);

// ---- dataset.json: the content of a release, with counts and sums ----

inline constexpr std::string_view dataset_name = "dataset.json";
inline constexpr std::string_view contents_name = "CONTENT_SHA256SUMS";

struct Dataset {
  Level level = Level::L0;
  std::string version;  ///< of the data
  std::uint64_t seed = 0;
  std::vector<Manifest> shards;
};

std::size_t records_in(const Dataset& dataset);

/// Returns CONTENT_SHA256SUMS: the sums of the decompressed files of all shards, as `sha256sum -c`
/// reads them. They are the same for every version of libzstd; SHA256SUMS, of the compressed files,
/// is not.
std::string contents_text(const Dataset& dataset);

/// JSON, dataset.schema.json; ends with a line feed.
std::string dataset_text(const Dataset& dataset);

/// Returns the dataset; nullopt unless dataset_text makes the same bytes of it.
std::optional<Dataset> parse_dataset(std::string_view text);

// ---- agreement.json: the methods that have computed every record of a release again ----

/// Written after the release is complete by the user who computed it again. It is not part of the
/// data: SHA256SUMS does not list it, and it identifies the contents itself.
inline constexpr std::string_view agreement_name = "agreement.json";

struct Agreement {
  std::string content_sha256;   ///< of the page CONTENT_SHA256SUMS
  std::size_t records = 0;      ///< records that were computed again
  std::vector<Method> methods;  ///< each computed every field of every record again; not empty
};

/// JSON, agreement.schema.json; ends with a line feed.
std::string agreement_text(const Agreement& agreement);

/// Returns the agreement; nullopt unless agreement_text makes the same bytes of it.
std::optional<Agreement> parse_agreement(std::string_view text);

// ---- the folder ----

/// Returns the pages that are the same in every release of this version: name and content.
std::vector<std::pair<std::string, std::string>> fixed_pages();

/// Returns the names of all files of a complete release with these shards, including SHA256SUMS;
/// agreement.json is optional.
std::set<std::string> release_names(const std::vector<ShardPlan>& shards);

// ---- generation ----

// Input   a level, a seed, a folder.
// Output  the release in that folder, or the requested part of its shards. Complete shards in it
//         are kept, so a run that was interrupted or killed goes on where it stopped. The bytes do
//         not depend on the number of threads or processes.

/// Progress, in base cases.
struct Done {
  std::size_t recipes = 0, of = 0;
  std::string shard;  ///< the shard being written
};

struct GenerateOptions {
  Level level = Level::L0;
  std::uint64_t seed = 1;
  std::filesystem::path folder;
  unsigned jobs = 0;                        ///< threads; 0: as many as there are cores
  Monitor* monitor = nullptr;               ///< asked by all threads whether to stop
  std::function<void(const Done&)> report;  ///< called from one thread at a time
};

class Generation {
 public:
  /// Reads the folder, or makes it. Throws FolderError if it holds anything other than this
  /// release, FileError.
  explicit Generation(GenerateOptions options);

  [[nodiscard]] const std::vector<ShardPlan>& shards() const { return shards_; }
  /// Returns the numbers of the shards that are missing or damaged, ascending. Reads the files.
  /// Throws as the constructor does.
  [[nodiscard]] std::vector<std::size_t> unfinished() const;
  /// Makes these shards, in this order. Throws FileError, Interrupted; std::logic_error if a record
  /// contradicts its certificate. Keeps shards that were finished before, and nothing of unfinished
  /// ones.
  void make(std::span<const std::size_t> numbers) const;
  /// Writes the pages that complete the release. Throws FolderError if a shard is missing,
  /// FileError.
  void close() const;

 private:
  GenerateOptions options_;
  std::vector<ShardPlan> shards_;
};

// ---- verification ----

// Input   the folder of a release, not trusted.
// Output  its faults. Refusal is the default: names, sums, pages, counts, every certificate and
//         every value are checked, and the page on methods that computed it again.

/// The result for one shard.
struct ShardResult {
  std::size_t records = 0;  ///< records that were proved
  std::optional<Refusal> refusal;
};

/// Receives the results of the shards in order, with their numbers. Returns whether to continue.
using TakeShard = std::function<bool(std::size_t shard, ShardResult result)>;

struct VerifyOptions {
  std::vector<Method> methods;  ///< compute every record again by each of these, besides proving it
  unsigned jobs = 0;            ///< threads; 0: as many as there are cores
  Monitor* monitor = nullptr;   ///< asked by all threads whether to stop
  std::function<void(std::size_t records, std::size_t of)> report;  ///< called from one thread at a time
  /// If set, this function has ShardVerifier prove the shards elsewhere, and passes the results to
  /// `take`: all of `shards`, or those before the first refusal.
  std::function<void(const std::vector<ShardPlan>& shards, const TakeShard& take)> elsewhere;
};

struct Verified {
  Level level = Level::L0;
  std::string version;
  std::uint64_t seed = 0;
  std::size_t shards = 0, records = 0;
  /// empty if accepted; otherwise every bad name, checksum and page, then the first bad record
  std::vector<Refusal> refusals;
};

/// Throws FileError if the folder itself cannot be read, Interrupted.
Verified verify(const std::filesystem::path& folder, const VerifyOptions& options = {});

/// Proves single shards of a release, whose pages are checked elsewhere.
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

/// Writes the page with the methods that computed the release again. Call it after verify accepted
/// the folder with these methods. Throws FileError.
void state_agreement(const std::filesystem::path& folder, const Verified& verified, const std::vector<Method>& methods);

// ---- the pages of every release and the heads of exports, which embedded.cmake compiles into the
// program ----

/// Returns NOTES.md of this folder, Markdown that ends with a line feed: fields and flags
/// explained, and the policy on versions.
std::string_view notes();

/// Returns golden.schema.json, the schema of a record.
std::string_view record_schema();

/// Returns LICENSES/CC0-1.0.txt.
std::string_view licence();

/// Returns dataset.schema.json, the schema of dataset.json.
std::string_view dataset_schema();

/// Returns shard.schema.json, the schema of the page of each shard.
std::string_view shard_schema();

/// Return kit/fathom_golden.h and kit/fathom_golden.rs: the type of a case, and tests of an answer
/// to it.
std::string_view kit_in_c();
std::string_view kit_in_rust();

}  // namespace fathom::golden
