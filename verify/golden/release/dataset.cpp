// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/release/dataset.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numeric>

#include "verify/golden/release/sums.hpp"
#include "verify/golden/shards/manifest_json.hpp"

namespace fathom::golden {
namespace {

using Json = nlohmann::ordered_json;

std::size_t total(const Dataset& dataset, std::size_t Manifest::*count) {
  return std::accumulate(dataset.shards.begin(), dataset.shards.end(), std::size_t{0},
                         [count](std::size_t sum, const Manifest& shard) { return sum + shard.*count; });
}

}  // namespace

std::size_t records_in(const Dataset& dataset) { return total(dataset, &Manifest::records); }

std::string contents_text(const Dataset& dataset) {
  std::vector<Sum> sums;
  for (const Manifest& shard : dataset.shards)
    for (const ShardFile& file : shard.files) sums.push_back({file.name.substr(0, file.name.rfind('.')), file.content.sha256});
  return sums_text(std::move(sums));
}

std::string dataset_text(const Dataset& dataset) {
  const std::string content = digest::digest_of(contents_text(dataset)).sha256;
  Json shards = Json::array();
  for (const Manifest& shard : dataset.shards) shards.push_back(manifest_json(shard));
  const Json json = {
      {"schema", "fathom/golden-dataset/1"},
      {"name", "fathom golden data " + std::string(name_of(dataset.level))},
      {"version", dataset.version},
      {"licence", "CC0-1.0"},
      {"generator", {{"name", "fathom"}, {"data_version", dataset.version}, {"seed", std::to_string(dataset.seed)}}},
      {"level", name_of(dataset.level)},
      {"cite", fmt::format("The fathom developers: fathom golden data {}, version {}, seed {}. CC0-1.0. Content SHA-256: {}",
                           name_of(dataset.level), dataset.version, dataset.seed, content)},
      {"content_sha256", content},
      {"recipes", total(dataset, &Manifest::recipes)},
      {"records", records_in(dataset)},
      {"schemas",
       {{"dataset.json", "dataset.schema.json"}, {"golden-*.json", "shard.schema.json"}, {"golden-*.jsonl.zst", "golden.schema.json"}}},
      {"shards", shards}};
  return json.dump(2) + '\n';
}

std::optional<Dataset> parse_dataset(std::string_view text) {
  try {
    const Json json = Json::parse(text);
    Dataset dataset;
    dataset.level = find_level(json.at("level").get<std::string>()).value();
    dataset.version = json.at("version").get<std::string>();
    dataset.seed = std::stoull(json.at("generator").at("seed").get<std::string>());
    for (const Json& shard : json.at("shards")) dataset.shards.push_back(manifest_of(shard));
    if (dataset_text(dataset) == text) return dataset;
  } catch (const std::exception&) {  // no JSON, or other fields than ours
  }
  return std::nullopt;
}

}  // namespace fathom::golden
