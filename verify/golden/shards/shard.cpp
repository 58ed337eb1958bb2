// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/shards/shard.hpp"

#include <utility>

#include "verify/golden/io/file_error.hpp"
#include "verify/golden/io/new_file.hpp"
#include "verify/golden/records/facts.hpp"

namespace fathom::golden {

ShardWriter::ShardWriter(std::filesystem::path folder, const ShardPlan& shard, std::uint64_t seed) : folder_(std::move(folder)) {
  manifest_.name = shard.name;
  manifest_.level = shard.level;
  manifest_.version = data_version;
  manifest_.seed = seed;
  manifest_.recipes = shard.count();
  manifest_.zstd = zstd_version();
  for (const std::string_view suffix : suffixes_of(shard.level))
    writers_.push_back(std::make_unique<ZstdWriter>(folder_, shard.name + std::string(suffix)));
  std::error_code error;
  std::filesystem::remove(folder_ / (shard.name + std::string(manifest_suffix)), error);
  if (error) throw FileError("remove", folder_ / (shard.name + std::string(manifest_suffix)), error.value());
  write_csv(csv_header());
}

/// Polytopes alone have one.
void ShardWriter::write_csv(std::string_view text) {
  if (kind_of(manifest_.level) == Kind::polytopes) writers_[2]->write(text);
}

void ShardWriter::add(const Record& record) {
  writers_[0]->write(record.line);
  writers_[0]->write("\n");
  writers_[1]->write(record.certificate);
  write_csv(record.csv_row);
  ++manifest_.records;
}

void ShardWriter::finish() {
  for (const std::unique_ptr<ZstdWriter>& writer : writers_) {
    writer->finish();
    manifest_.files.push_back({writer->name(), writer->of_file(), writer->of_content()});
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
