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

struct Dataset {
  Level level = Level::L0;
  std::string version;  ///< of the data
  std::uint64_t seed = 0;
  std::vector<Manifest> shards;
};

std::size_t records_in(const Dataset& dataset);

/// JSON, schemas/dataset.schema.json; ends with a line feed.
std::string dataset_text(const Dataset& dataset);

/// Returns nullopt unless `text` is, byte for byte, what dataset_text makes of it.
std::optional<Dataset> parse_dataset(std::string_view text);

}  // namespace fathom::golden
