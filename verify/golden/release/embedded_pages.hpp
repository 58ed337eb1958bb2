// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of every release and the heads of exports, which embedded.cmake compiles into the
// program.
#pragma once

#include <string_view>

namespace fathom::golden {

/// NOTES.md of this folder: fields and flags explained, and the policy on versions. Markdown, ends
/// with a line feed.
std::string_view notes();

/// golden.schema.json: of one record.
std::string_view record_schema();

/// LICENSES/CC0-1.0.txt.
std::string_view licence();

/// dataset.schema.json: of dataset.json.
std::string_view dataset_schema();

/// shard.schema.json: of the page of each shard.
std::string_view shard_schema();

/// kit/fathom_golden.h and kit/fathom_golden.rs: what a case is, and whether an answer to it is
/// right.
std::string_view kit_in_c();
std::string_view kit_in_rust();

}  // namespace fathom::golden
