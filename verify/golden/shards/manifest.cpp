// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "verify/golden/io/files.hpp"
#include "verify/golden/shards/shard.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::ordered_json;

Json file_json(const ShardFile& entry) {
  return {{"name", entry.name},
          {"bytes", entry.file.bytes},
          {"sha256", entry.file.sha256},
          {"content_bytes", entry.content.bytes},
          {"content_sha256", entry.content.sha256}};
}

ShardFile file_of(const Json& json) {
  return {json.at("name").get<std::string>(),
          {json.at("bytes").get<std::uint64_t>(), json.at("sha256").get<std::string>()},
          {json.at("content_bytes").get<std::uint64_t>(), json.at("content_sha256").get<std::string>()}};
}

}  // namespace

std::span<const std::string_view> suffixes_of(Level level) {
  return std::span(shard_suffixes).first(kind_of(level) == Kind::polytopes ? 3 : 2);
}

nlohmann::ordered_json manifest_json(const Manifest& manifest) {
  Json files = Json::array();
  for (const ShardFile& entry : manifest.files) files.push_back(file_json(entry));
  return {{"schema", "fathom/golden-shard/1"},
          {"name", manifest.name},
          {"level", name_of(manifest.level)},
          {"version", manifest.version},
          {"seed", std::to_string(manifest.seed)},
          {"recipes", manifest.recipes},
          {"records", manifest.records},
          {"zstd", manifest.zstd},
          {"files", files}};
}

Manifest manifest_of(const nlohmann::ordered_json& json) {
  Manifest manifest;
  manifest.name = json.at("name").get<std::string>();
  manifest.level = find_level(json.at("level").get<std::string>()).value();
  manifest.version = json.at("version").get<std::string>();
  manifest.seed = std::stoull(json.at("seed").get<std::string>());
  manifest.recipes = json.at("recipes").get<std::size_t>();
  manifest.records = json.at("records").get<std::size_t>();
  manifest.zstd = json.at("zstd").get<std::string>();
  for (std::size_t i = 0; i < suffixes_of(manifest.level).size(); ++i) manifest.files.push_back(file_of(json.at("files").at(i)));
  return manifest;
}

std::string manifest_text(const Manifest& manifest) { return manifest_json(manifest).dump(2) + '\n'; }

std::optional<Manifest> parse_manifest(std::string_view text) {
  try {
    Manifest manifest = manifest_of(Json::parse(text));
    if (manifest_text(manifest) == text) return manifest;
  } catch (const std::exception&) {  // no JSON, or other fields than ours
  }
  return std::nullopt;
}

std::optional<std::string> not_of_plan(const Manifest& manifest, const ShardPlan& shard, std::uint64_t seed) {
  if (manifest.version != data_version)
    return fmt::format("is of data version {}, and this program makes {}", manifest.version, data_version);
  if (manifest.seed != seed) return fmt::format("was made from seed {} instead of {}", manifest.seed, seed);
  const std::span<const std::string_view> suffixes = suffixes_of(shard.level);
  bool same = manifest.name == shard.name && manifest.level == shard.level && manifest.recipes == shard.count();
  for (std::size_t i = 0; same && i < suffixes.size(); ++i) same = manifest.files[i].name == shard.name + std::string(suffixes[i]);
  if (!same) return fmt::format("is not about {} as this version plans it", shard.name);
  return std::nullopt;
}

ShardState state_of(const std::filesystem::path& folder, const ShardPlan& shard, std::uint64_t seed) {
  const std::filesystem::path page = folder / (shard.name + std::string(manifest_suffix));
  if (!std::filesystem::exists(std::filesystem::symlink_status(page))) return ShardState::absent;
  const std::optional<Manifest> manifest = parse_manifest(read_small_file(page));
  if (!manifest) return ShardState::damaged;
  if (const auto fault = not_of_plan(*manifest, shard, seed)) throw FolderError(page.string() + ' ' + *fault);
  for (const ShardFile& entry : manifest->files) {
    if (!std::filesystem::is_regular_file(folder / entry.name)) return ShardState::damaged;
    if (digest_of_file(folder / entry.name) != entry.file) return ShardState::damaged;
  }
  return ShardState::finished;
}

}  // namespace fathom::golden
