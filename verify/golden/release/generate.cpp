// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <memory>
#include <optional>
#include <utility>

#include "fathom/depth.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/release/release.hpp"
#include "verify/golden/shards/shard.hpp"

namespace fathom::golden {
namespace {

constexpr std::size_t recipes_in_flight = 32;  // for each thread; bounds the memory

/// Recipe after recipe of several shards, made on all threads and written in order by one at a time.
class Assembly {
 public:
  Assembly(const GenerateOptions& options, const std::vector<ShardPlan>& shards, std::span<const std::size_t> numbers)
      : options_(&options), shards_(&shards), numbers_(numbers) {
    for (const std::size_t number : numbers) done_.of += shards[number].count();
  }

  void run(unsigned threads) {
    using tbb::filter_mode;
    tbb::parallel_pipeline(
        threads * recipes_in_flight,
        tbb::make_filter<void, Given>(filter_mode::serial_in_order, [this](tbb::flow_control& control) { return next(control); }) &
            tbb::make_filter<Given, Records>(filter_mode::parallel, [this](Given given) { return made(*given); }) &
            tbb::make_filter<Records, void>(filter_mode::serial_in_order, [this](const Records& records) { write(*records); }));
  }

 private:
  using Given = std::shared_ptr<Recipe>;
  using Records = std::shared_ptr<std::vector<Record>>;

  const ShardPlan& shard(std::size_t place) const { return (*shards_)[numbers_[place]]; }

  Given next(tbb::flow_control& control) {
    while (given_recipe_ == recipes_.size()) {
      if (given_shard_ == numbers_.size()) {
        control.stop();
        return nullptr;
      }
      recipes_ = shard(given_shard_++).recipes();
      given_recipe_ = 0;
    }
    return std::make_shared<Recipe>(std::move(recipes_[given_recipe_++]));
  }

  Records made(const Recipe& recipe) {
    return std::make_shared<std::vector<Record>>(records_of(recipe, options_->monitor, &workspaces_.local()));
  }

  void write(const std::vector<Record>& records) {
    const ShardPlan& now = shard(written_shard_);
    if (!writer_) writer_.emplace(options_->folder, now, options_->seed);
    for (const Record& record : records) writer_->add(record);
    if (++written_recipe_ == now.count()) {
      writer_->finish();
      writer_.reset();
      written_recipe_ = 0;
      ++written_shard_;
    }
    ++done_.recipes;
    done_.shard = now.name;
    if (options_->report) options_->report(done_);
  }

  const GenerateOptions* options_;
  const std::vector<ShardPlan>* shards_;
  std::span<const std::size_t> numbers_;
  std::vector<Recipe> recipes_;  // of the shard that is given out; for the first stage, as the next line
  std::size_t given_shard_ = 0, given_recipe_ = 0;
  std::size_t written_shard_ = 0, written_recipe_ = 0;  // of the last one
  std::optional<ShardWriter> writer_;
  tbb::enumerable_thread_specific<Workspace> workspaces_;
  Done done_;
};

unsigned threads_of(const GenerateOptions& options) {
  return options.jobs > 0 ? options.jobs : static_cast<unsigned>(tbb::this_task_arena::max_concurrency());
}

}  // namespace

Generation::Generation(GenerateOptions options) : options_(std::move(options)), shards_(plan(options_.level, options_.seed)) {
  prepare_folder(options_.folder, shards_);
}

std::vector<std::size_t> Generation::unfinished() const {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < shards_.size(); ++i)
    if (state_of(options_.folder, shards_[i], options_.seed) != ShardState::finished) numbers.push_back(i);
  return numbers;
}

void Generation::make(std::span<const std::size_t> numbers) const {
  if (numbers.empty()) return;
  open_release(options_.folder);
  const unsigned threads = threads_of(options_);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] { Assembly(options_, shards_, numbers).run(threads); });
}

void Generation::close() const {
  for (const ShardPlan& shard : shards_)
    if (!std::filesystem::exists(options_.folder / (shard.name + std::string(manifest_suffix))))
      throw FolderError(options_.folder.string() + " lacks " + shard.name + ": the release cannot be completed");
  close_release(options_.folder, options_.level, options_.seed, shards_);
}

}  // namespace fathom::golden
