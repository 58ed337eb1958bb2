// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/golden/shards/shard.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "kernels/context.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::golden {
namespace {

using text::Json;
using text::JsonValue;

Json file_json(const ShardFile& entry) {
  return {{"name", entry.name},
          {"bytes", entry.file.bytes},
          {"sha256", entry.file.sha256},
          {"content_bytes", entry.content.bytes},
          {"content_sha256", entry.content.sha256}};
}

ShardFile file_of(const JsonValue& json) {
  return {json.at("name").string(),
          {json.at("bytes").natural(), json.at("sha256").string()},
          {json.at("content_bytes").natural(), json.at("content_sha256").string()}};
}

}  // namespace

std::span<const std::string_view> suffixes_of(Level level) {
  return std::span(shard_suffixes).first(of_polytopes(level) ? 3 : 2);
}

Json manifest_json(const Manifest& manifest) {
  return {{"schema", "fathom/golden-shard/1"},
          {"name", manifest.name},
          {"level", name_of(manifest.level)},
          {"version", manifest.version},
          {"seed", std::to_string(manifest.seed)},
          {"recipes", manifest.recipes},
          {"records", manifest.records},
          {"zstd", manifest.zstd},
          {"files", Json::array_of(manifest.files, file_json)}};
}

Manifest manifest_of(const JsonValue& json) {
  Manifest manifest;
  manifest.name = json.at("name").string();
  manifest.level = find_level(json.at("level").string()).value();
  manifest.version = json.at("version").string();
  manifest.seed = std::stoull(json.at("seed").string());
  manifest.recipes = json.at("recipes").natural();
  manifest.records = json.at("records").natural();
  manifest.zstd = json.at("zstd").string();
  for (std::size_t i = 0; i < suffixes_of(manifest.level).size(); ++i)
    manifest.files.push_back(file_of(json.at("files").at(i)));
  return manifest;
}

std::string manifest_text(const Manifest& manifest) { return manifest_json(manifest).indented() + '\n'; }

std::optional<Manifest> parse_manifest(std::string_view text) {
  try {
    Manifest manifest = manifest_of(text::parsed_json(text));
    if (manifest_text(manifest) == text) return manifest;
  } catch (const std::exception&) {  // the text is no JSON, or has other fields than a manifest
  }
  return std::nullopt;
}

std::optional<std::string> not_of_plan(const Manifest& manifest, const ShardPlan& shard, std::uint64_t seed) {
  if (manifest.version != data_version)
    return fmt::format("is of data version {}, and this program makes {}", manifest.version, data_version);
  if (manifest.seed != seed) return fmt::format("was made from seed {} instead of {}", manifest.seed, seed);
  const std::span<const std::string_view> suffixes = suffixes_of(shard.level);
  bool same = manifest.name == shard.name && manifest.level == shard.level && manifest.recipes == shard.count();
  for (std::size_t i = 0; same && i < suffixes.size(); ++i)
    same = manifest.files[i].name == shard.name + std::string(suffixes[i]);
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

// ---- writing ----

ShardWriter::ShardWriter(std::filesystem::path folder, const ShardPlan& shard, std::uint64_t seed)
    : folder_(std::move(folder)) {
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

/// Writes to the CSV file, which only shards of polytopes have.
void ShardWriter::write_csv(std::string_view text) {
  if (of_polytopes(manifest_.level)) writers_[2]->write(text);
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
  const std::string name = manifest_.name + std::string(manifest_suffix);
  files::WholeFile page(folder_ / name, std::string(hidden_prefix) + name);  // a full disk then renames no file
  page.write(manifest_text(manifest_));
  page.sync();
  rename_all();
  sync_folder(folder_);
  page.put_in_place();
  sync_folder(folder_);
}

/// Renames all files; if one fails, removes those already renamed.
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

// ---- verification ----

namespace {

constexpr std::size_t groups_in_flight = 32;  // for each thread
constexpr std::size_t largest_group = 3;      // one record for each form
constexpr std::size_t largest_certificate = std::size_t{512} << 20;

/// A compressed file of the shard; its faults are thrown as Refusals.
class Stream {
 public:
  Stream(const std::filesystem::path& folder, const ShardFile& file) : name_(file.name), expected_(&file) {
    guarded([&] { reader_ = std::make_unique<ZstdReader>(folder / file.name); });
  }
  std::optional<std::string_view> line() {
    std::optional<std::string_view> found;
    guarded([&] { found = reader_->line(); });
    return found;
  }
  [[nodiscard]] Refusal refusal(const std::string& reason) const {
    return {reader_ && reader_->number() > 0 ? fmt::format("{}:{}", name_, reader_->number()) : name_, reason};
  }
  /// Throws a Refusal unless the next lines are those of `text`.
  void expect(std::string_view text, const char* what) {
    while (!text.empty()) {
      const std::size_t length = text.find('\n');
      const std::optional<std::string_view> found = line();
      if (!found || *found != text.substr(0, length))
        throw refusal(fmt::format("{} {}", found ? "this is not" : "the file lacks", what));
      text.remove_prefix(length + 1);
    }
  }
  /// Throws a Refusal if more lines follow, or if the sum differs from that of the page.
  void expect_end() {
    if (line()) throw refusal("more than the records of the shard");
    if (reader_->of_content() != expected_->content)
      throw Refusal{name_, "the content is not what the shard's page says"};
  }

 private:
  template <class Action>
  void guarded(Action action) const {
    try {
      action();
    } catch (const FileError& error) {
      throw refusal(error.what());
    }
  }
  std::string name_;
  const ShardFile* expected_;
  std::unique_ptr<ZstdReader> reader_;
};

struct Item {
  std::string line, certificate, record_place;  // input
  std::string id, row;                          // computed
};

/// The records of one recipe, or those up to a fault in their order.
struct Group {
  std::vector<Item> items;
  std::optional<Refusal> refusal;  // on the record after the items, found in reading or proving
  std::vector<std::string> ids;    // of all records of the first item's recipe
};

/// Returns whether the id is that of a rounded record, which the exact one may precede.
bool is_rounded(std::string_view id) { return id.ends_with(".b64") || id.ends_with(".b32"); }

class Verification {
 public:
  Verification(const std::filesystem::path& folder, const ShardPlan& shard, const Manifest& manifest,
               const ShardOptions& options)
      : manifest_(&manifest),
        options_(&options),
        planned_(shard.recipes()),
        order_(planned_),
        records_(folder, manifest.files[0]),
        certificates_(folder, manifest.files[1]) {
    if (manifest.files.size() > 2) csv_.emplace(folder, manifest.files[2]);
  }

  std::optional<Refusal> run() {
    using tbb::filter_mode;
    if (csv_) csv_->expect(csv_header(), "the header");
    tbb::parallel_pipeline(
        static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) * groups_in_flight,
        tbb::make_filter<void, Shared>(filter_mode::serial_in_order, [this](tbb::flow_control& control) {
          return next(control);
        }) & tbb::make_filter<Shared, Shared>(filter_mode::parallel, [this](const Shared& group) {
          return prove(group);
        }) & tbb::make_filter<Shared, void>(filter_mode::serial_in_order, [this](const Shared& group) {
          accept(*group);
        }));
    if (refusal_) return refusal_;
    if (const auto fault = order_.at_end()) throw records_.refusal(*fault);
    if (count_ != manifest_->records)
      throw records_.refusal(fmt::format("{} records, and the page says {}", count_, manifest_->records));
    for (Stream* stream : {&records_, &certificates_}) stream->expect_end();
    if (csv_) csv_->expect_end();
    return std::nullopt;
  }

 private:
  using Shared = std::shared_ptr<Group>;

  Shared next(tbb::flow_control& control) {
    if (ended_ || refused_) return control.stop(), nullptr;
    auto group = std::make_shared<Group>();
    try {
      do {
        std::optional<Item> item = std::exchange(ahead_, std::nullopt);
        if (!item) item = read();
        if (!item) break;
        group->items.push_back(std::move(*item));
      } while ((ahead_ = read()) && is_rounded(id_in(ahead_->line)) && group->items.size() < largest_group);
    } catch (Refusal& refusal) {
      group->refusal = std::move(refusal);
      ended_ = true;
    }
    if (group->items.empty() && !group->refusal) return control.stop(), nullptr;
    return group;
  }

  std::optional<Item> read() {
    const std::optional<std::string_view> line = records_.line();
    if (!line) return std::nullopt;
    Item item;
    item.line = *line;
    item.record_place = records_.refusal("").place;
    read_certificate(item);
    return item;
  }

  void read_certificate(Item& item) {
    do {
      const std::optional<std::string_view> line = certificates_.line();
      if (!line) throw certificates_.refusal("the certificate of " + item.record_place + " is missing or cut off");
      (item.certificate += *line) += '\n';
      if (item.certificate.size() > largest_certificate) throw certificates_.refusal("a certificate is too long");
      if (line->starts_with("end ")) return;
    } while (true);
  }

  Shared prove(const Shared& group) {
    Prover& prover = provers_.local();
    for (std::size_t i = 0; i < group->items.size(); ++i) {
      kernels::Context(options_->monitor).check();
      if (refused_) return group;  // an earlier group was refused
      Item& item = group->items[i];
      if (auto fault = fault_in(prover, item)) {
        group->refusal = {item.record_place, std::move(*fault)};
        group->items.resize(i);
        break;
      }
      item.id = prover.id();
      item.row = prover.row();
      if (i == 0) group->ids = prover.ids();
    }
    return group;
  }

  std::optional<std::string> fault_in(Prover& prover, const Item& item) const {
    std::optional<std::string> fault = prover.faults_of(item.line, item.certificate);
    for (const Method method : options_->methods)
      if (!fault) fault = disagreement_with(method, item.line, options_->monitor);
    return fault;
  }

  void accept(Group& group) {
    if (refusal_) return;
    try {
      for (const Item& item : group.items) {
        if (const auto fault = order_.next(item.id, group.ids)) throw Refusal{item.record_place, *fault};
        if (csv_) csv_->expect(item.row, "the row of this record");
        ++count_;
        if (options_->proved) options_->proved();
      }
      if (group.refusal) throw std::move(*group.refusal);
    } catch (Refusal& refusal) {
      refusal_ = std::move(refusal);
      refused_ = true;
    }
  }

  const Manifest* manifest_;
  const ShardOptions* options_;
  const std::vector<Recipe> planned_;
  tbb::enumerable_thread_specific<Prover> provers_;
  RecordOrder order_;
  Stream records_, certificates_;
  std::optional<Stream> csv_;       // for polytopes only
  std::optional<Item> ahead_;       // for the first stage: read already, but part of the next group
  bool ended_ = false;              // for the first stage: the end of the records, or a fault
  std::optional<Refusal> refusal_;  // for the last stage
  std::atomic<bool> refused_ = false;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<Refusal> refusal_of_shard(const std::filesystem::path& folder, const ShardPlan& shard,
                                        const Manifest& manifest, const ShardOptions& options) {
  try {
    return Verification(folder, shard, manifest, options).run();
  } catch (Refusal& refusal) {
    return std::move(refusal);
  }
}

}  // namespace fathom::golden
