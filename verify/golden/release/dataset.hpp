// SPDX-License-Identifier: GPL-3.0-or-later
// dataset.json: what a release holds, with counts and sums.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/golden/shards/manifest.hpp"

namespace fathom::golden {

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

}  // namespace fathom::golden
