// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/shards/verify_shard.hpp"

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "kernels/context.hpp"
#include "verify/golden/io/file_error.hpp"
#include "verify/golden/io/zstd_file.hpp"
#include "verify/golden/records/exports.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/recompute.hpp"
#include "verify/golden/records/record_order.hpp"

namespace fathom::golden {
namespace {

constexpr std::size_t records_in_flight = 32;  // for each thread
constexpr std::size_t largest_certificate = std::size_t{512} << 20;

/// A stream of the shard, with what goes wrong in it as a Refusal.
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
  /// The next lines have to be those of `text`.
  void expect(std::string_view text, const char* what) {
    while (!text.empty()) {
      const std::size_t length = text.find('\n');
      const std::optional<std::string_view> found = line();
      if (!found || *found != text.substr(0, length)) throw refusal(fmt::format("{} {}", found ? "this is not" : "the file lacks", what));
      text.remove_prefix(length + 1);
    }
  }
  /// Nothing may follow, and the sum has to be that of the page.
  void expect_end() {
    if (line()) throw refusal("more than the records of the shard");
    if (reader_->of_content() != expected_->content) throw Refusal{name_, "the content is not what the shard's page says"};
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
  std::string line, certificate, record_place;  // read
  std::optional<Refusal> refusal;               // found in reading or proving
  std::string id, csv, include;                 // made
  std::vector<std::string> ids;                 // of the recipe that the record is the first of
};

class Verification {
 public:
  Verification(const std::filesystem::path& folder, const ShardPlan& shard, const Manifest& manifest, const ShardOptions& options)
      : manifest_(&manifest),
        options_(&options),
        planned_(shard.recipes()),
        order_(planned_),
        records_(folder, manifest.files[0]),
        certificates_(folder, manifest.files[1]),
        csv_(folder, manifest.files[2]),
        include_(folder, manifest.files[3]) {
    for (const Recipe& recipe : planned_) recipes_.emplace(id_of(recipe), &recipe);
  }

  std::optional<Refusal> run() {
    using tbb::filter_mode;
    csv_.expect(csv_header(), "the header");
    include_.expect(include_head(), "the head of an include file");
    tbb::parallel_pipeline(
        static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) * records_in_flight,
        tbb::make_filter<void, Shared>(filter_mode::serial_in_order, [this](tbb::flow_control& control) { return next(control); }) &
            tbb::make_filter<Shared, Shared>(filter_mode::parallel, [this](const Shared& item) { return prove(item); }) &
            tbb::make_filter<Shared, void>(filter_mode::serial_in_order, [this](const Shared& item) { accept(*item); }));
    if (refusal_) return refusal_;
    if (const auto fault = order_.at_end()) throw records_.refusal(*fault);
    if (count_ != manifest_->records) throw records_.refusal(fmt::format("{} records, and the page says {}", count_, manifest_->records));
    include_.expect(include_tail(), "the end of an include file");
    for (Stream* stream : {&records_, &certificates_, &csv_, &include_}) stream->expect_end();
    return std::nullopt;
  }

 private:
  using Shared = std::shared_ptr<Item>;

  Shared next(tbb::flow_control& control) {
    if (stopped_) return control.stop(), nullptr;
    auto item = std::make_shared<Item>();
    try {
      const std::optional<std::string_view> line = records_.line();
      if (!line) return control.stop(), nullptr;
      item->line = *line;
      item->record_place = records_.refusal("").place;
      read_certificate(*item);
    } catch (Refusal& refusal) {
      item->refusal = std::move(refusal);
      stopped_ = true;
    }
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

  Shared prove(const Shared& item) const {
    kernels::Context(options_->monitor).check();
    if (item->refusal || stopped_) return item;
    if (auto fault = fault_in(*item)) {
      item->refusal = {item->record_place, std::move(*fault)};
    } else {
      item->id = id_in(item->line);
      if (const auto first = recipes_.find(item->id); first != recipes_.end()) item->ids = ids_of(*first->second);
      Exports exports = exports_of(item->line);
      item->csv = std::move(exports.csv_row);
      item->include = std::move(exports.include_entry);
    }
    return item;
  }

  std::optional<std::string> fault_in(const Item& item) const {
    std::optional<std::string> fault = faults_of(item.line, item.certificate);
    for (const Method method : options_->methods)
      if (!fault) fault = disagreement_with(method, item.line, options_->monitor);
    return fault;
  }

  void accept(Item& item) {
    if (refusal_) return;
    try {
      if (item.refusal) throw std::move(*item.refusal);
      if (const auto fault = order_.next(item.id, item.ids)) throw Refusal{item.record_place, *fault};
      csv_.expect(item.csv, "the row of this record");
      include_.expect(item.include, "the entry of this record");
      ++count_;
      if (options_->proved) options_->proved();
    } catch (Refusal& refusal) {
      refusal_ = std::move(refusal);
      stopped_ = true;
    }
  }

  const Manifest* manifest_;
  const ShardOptions* options_;
  std::map<std::string, const Recipe*> recipes_;  // by the ids of their first records
  const std::vector<Recipe> planned_;
  RecordOrder order_;
  Stream records_, certificates_, csv_, include_;
  std::optional<Refusal> refusal_;  // of the last stage
  std::atomic<bool> stopped_ = false;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<Refusal> refusal_of_shard(const std::filesystem::path& folder, const ShardPlan& shard, const Manifest& manifest,
                                        const ShardOptions& options) {
  try {
    return Verification(folder, shard, manifest, options).run();
  } catch (Refusal& refusal) {
    return std::move(refusal);
  }
}

}  // namespace fathom::golden
