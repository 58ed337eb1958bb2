// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of a release that are the same in each, part of the program.
#pragma once

#include <string_view>

namespace fathom::golden {

/// LICENSES/CC0-1.0.txt.
std::string_view licence();

/// schemas/dataset.schema.json: of dataset.json.
std::string_view dataset_schema();

/// schemas/shard.schema.json: of the page of each shard.
std::string_view shard_schema();

}  // namespace fathom::golden
