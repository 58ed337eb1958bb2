// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/release/release.hpp"

#include <system_error>

#include "kernels/printable.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/io/file_error.hpp"
#include "verify/golden/io/input_file.hpp"
#include "verify/golden/io/new_file.hpp"
#include "verify/golden/release/agreement.hpp"
#include "verify/golden/release/dataset.hpp"
#include "verify/golden/release/embedded_pages.hpp"
#include "verify/golden/release/sums.hpp"

namespace fathom::golden {
namespace fs = std::filesystem;

std::vector<std::pair<std::string, std::string>> fixed_pages() {
  return {{"LICENSE", std::string(licence())},
          {"NOTES.md", std::string(notes())},
          {"dataset.schema.json", std::string(dataset_schema())},
          {"golden.schema.json", std::string(record_schema())},
          {"shard.schema.json", std::string(shard_schema())}};
}

std::set<std::string> release_names(const std::vector<ShardPlan>& shards) {
  std::set<std::string> names = {std::string(dataset_name), std::string(contents_name), std::string(sums_name)};
  for (const auto& [name, text] : fixed_pages()) names.insert(name);
  for (const ShardPlan& shard : shards) {
    names.insert(shard.name + std::string(manifest_suffix));
    for (const std::string_view suffix : suffixes_of(shard.level)) names.insert(shard.name + std::string(suffix));
  }
  return names;
}

void prepare_folder(const fs::path& folder, const std::vector<ShardPlan>& shards) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    if (!error) error = std::make_error_code(std::errc::not_a_directory);
    throw FileError("make the folder", folder, error.value());
  }
  std::set<std::string> names = release_names(shards);
  names.insert(std::string(agreement_name));
  fs::directory_iterator entries(folder, error);
  if (error) throw FileError("read the folder", folder, error.value());
  for (const fs::directory_entry& entry : entries) {
    std::string name = entry.path().filename().string();
    if (name.starts_with(hidden_prefix)) name.erase(0, hidden_prefix.size());
    if (names.count(name) == 0)
      throw FolderError(folder.string() + " holds " + kernels::shown(name) + ", which is no file of this release");
  }
}

void open_release(const fs::path& folder) {
  for (const std::string_view name : {agreement_name, sums_name, contents_name, dataset_name}) {
    std::error_code error;
    fs::remove(folder / name, error);
    if (error) throw FileError("remove", folder / name, error.value());
  }
}

void close_release(const fs::path& folder, Level level, std::uint64_t seed, const std::vector<ShardPlan>& shards) {
  Dataset dataset{level, std::string(data_version), seed, {}};
  std::vector<Sum> sums;
  const auto put = [&](const std::string& name, std::string_view text) {
    put_file(folder, name, text);
    sums.push_back({name, digest::digest_of(text).sha256});
  };
  for (const ShardPlan& shard : shards) {
    const std::string page = shard.name + std::string(manifest_suffix), text = read_small_file(folder / page);
    dataset.shards.push_back(parse_manifest(text).value());
    sums.push_back({page, digest::digest_of(text).sha256});
    for (const ShardFile& file : dataset.shards.back().files) sums.push_back({file.name, file.file.sha256});
  }
  for (const auto& [name, text] : fixed_pages()) put(name, text);
  put(std::string(dataset_name), dataset_text(dataset));
  put(std::string(contents_name), contents_text(dataset));
  put_file(folder, std::string(sums_name), sums_text(sums));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))  // of processes that were killed
    if (entry.path().filename().string().starts_with(hidden_prefix)) fs::remove(entry.path());
}

}  // namespace fathom::golden
