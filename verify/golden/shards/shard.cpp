// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/shards/shard.hpp"

#include <utility>

#include "verify/golden/io/file_error.hpp"
#include "verify/golden/io/new_file.hpp"
#include "verify/golden/records/exports.hpp"

namespace fathom::golden {

ShardWriter::ShardWriter(std::filesystem::path folder, const ShardPlan& shard, std::uint64_t seed) : folder_(std::move(folder)) {
  manifest_.name = shard.name;
  manifest_.level = shard.level;
  manifest_.version = data_version;
  manifest_.seed = seed;
  manifest_.recipes = shard.count();
  manifest_.zstd = zstd_version();
  for (const std::string_view suffix : shard_suffixes)
    writers_.push_back(std::make_unique<ZstdWriter>(folder_, shard.name + std::string(suffix)));
  std::error_code error;
  std::filesystem::remove(folder_ / (shard.name + std::string(manifest_suffix)), error);
  if (error) throw FileError("remove", folder_ / (shard.name + std::string(manifest_suffix)), error.value());
  writers_[2]->write(csv_header());
  writers_[3]->write(include_head());
}

void ShardWriter::add(const Record& record) {
  writers_[0]->write(record.line);
  writers_[0]->write("\n");
  writers_[1]->write(record.certificate);
  writers_[2]->write(record.exports.csv_row);
  writers_[3]->write(record.exports.include_entry);
  ++manifest_.records;
}

void ShardWriter::finish() {
  writers_[3]->write(include_tail());
  for (std::size_t i = 0; i < writers_.size(); ++i) {
    writers_[i]->finish();
    manifest_.files[i] = {writers_[i]->name(), writers_[i]->of_file(), writers_[i]->of_content()};
  }
  NewFile page(folder_, manifest_.name + std::string(manifest_suffix));  // before the names appear: where the disk is full, none does
  page.write(manifest_text(manifest_));
  page.sync();
  rename_all();
  sync_folder(folder_);
  page.commit();
  sync_folder(folder_);
}

/// All names or none, as far as the system lets us.
void ShardWriter::rename_all() {
  std::size_t renamed = 0;
  try {
    for (; renamed < writers_.size(); ++renamed) writers_[renamed]->commit();
  } catch (const FileError&) {
    std::error_code ignored;
    for (std::size_t i = 0; i < renamed; ++i) std::filesystem::remove(folder_ / manifest_.files[i].name, ignored);
    throw;
  }
}

}  // namespace fathom::golden
