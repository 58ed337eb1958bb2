// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of every release and the heads of exports, which embedded.cmake compiles into the
// program.
#pragma once

#include <string_view>

namespace fathom::golden {

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
