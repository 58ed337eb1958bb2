// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/golden/release/release.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <system_error>
#include <utility>

#include "fathom/depth.hpp"
#include "kernels/messages.hpp"
#include "reference/solve/depth.hpp"
#include "verify/digest/sha256.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/shards/shard.hpp"

namespace fathom::golden {
namespace fs = std::filesystem;

// ---- sums ----

namespace {

using text::Json;
using text::JsonValue;

constexpr std::size_t digits = 64;

bool is_plain_name(std::string_view name) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.";
  return !name.empty() && name.front() != '.' && name.find_first_not_of(letters) == std::string_view::npos;
}

/// Writes the fixed pages, dataset.json, CONTENT_SHA256SUMS and, last, SHA256SUMS. All shards must
/// exist. Throws FileError.
void close_release(const fs::path& folder, Level level, std::uint64_t seed, const std::vector<ShardPlan>& shards) {
  Dataset dataset{level, std::string(data_version), seed, {}};
  std::vector<Sum> sums;
  const auto put = [&](const std::string& name, std::string_view text) {
    put_file(folder, name, text);
    sums.push_back({name, digest::digest_of(text).sha256});
  };
  for (const ShardPlan& shard : shards) {
    const std::string page = shard.name + std::string(manifest_suffix), text = read_small_file(folder / page);
    dataset.shards.push_back(parse_manifest(text).value());
    sums.push_back({page, digest::digest_of(text).sha256});
    for (const ShardFile& file : dataset.shards.back().files) sums.push_back({file.name, file.file.sha256});
  }
  for (const auto& [name, text] : fixed_pages()) put(name, text);
  put(std::string(dataset_name), dataset_text(dataset));
  put(std::string(contents_name), contents_text(dataset));
  put_file(folder, std::string(sums_name), sums_text(sums));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))  // left by processes that were killed
    if (entry.path().filename().string().starts_with(hidden_prefix)) fs::remove(entry.path());
}

/// Removes the pages that only a complete release has: dataset.json, both pages of sums,
/// agreement.json. Throws FileError.
void open_release(const fs::path& folder) {
  for (const std::string_view name : {agreement_name, sums_name, contents_name, dataset_name}) {
    std::error_code error;
    fs::remove(folder / name, error);
    if (error) throw FileError("remove", folder / name, error.value());
  }
}

/// Makes the folder if it is missing. Throws FolderError if it holds anything but files of this
/// release, finished or not; FileError.
void prepare_folder(const fs::path& folder, const std::vector<ShardPlan>& shards) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    if (!error) error = std::make_error_code(std::errc::not_a_directory);
    throw FileError("make the folder", folder, error.value());
  }
  std::set<std::string> names = release_names(shards);
  names.insert(std::string(agreement_name));
  fs::directory_iterator entries(folder, error);
  if (error) throw FileError("read the folder", folder, error.value());
  for (const fs::directory_entry& entry : entries) {
    std::string name = entry.path().filename().string();
    if (name.starts_with(hidden_prefix)) name.erase(0, hidden_prefix.size());
    if (names.count(name) == 0)
      throw FolderError(folder.string() + " holds " + kernels::shown(name) + ", which is no file of this release");
  }
}

}  // namespace

std::string sums_text(std::vector<Sum> sums) {
  std::ranges::sort(sums, {}, &Sum::name);
  std::string text;
  for (const Sum& sum : sums) text += sum.sha256 + "  " + sum.name + '\n';
  return text;
}

std::optional<std::vector<Sum>> parse_sums(std::string_view text) {
  std::vector<Sum> sums;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    if (line.size() == rest.size() || line.size() < digits + 3) return std::nullopt;
    rest.remove_prefix(line.size() + 1);
    sums.push_back({std::string(line.substr(digits + 2)), std::string(line.substr(0, digits))});
    const Sum& sum = sums.back();
    if (!is_plain_name(sum.name) || sum.sha256.find_first_not_of("0123456789abcdef") != std::string::npos)
      return std::nullopt;
    if (sums.size() > 1 && sums[sums.size() - 2].name >= sum.name) return std::nullopt;
  }
  if (sums_text(sums) != text) return std::nullopt;
  return sums;
}

// ---- dataset.json ----

namespace {

std::size_t total(const Dataset& dataset, std::size_t Manifest::*count) {
  return std::accumulate(dataset.shards.begin(), dataset.shards.end(), std::size_t{0},
                         [count](std::size_t sum, const Manifest& shard) { return sum + shard.*count; });
}

}  // namespace

std::size_t records_in(const Dataset& dataset) { return total(dataset, &Manifest::records); }

std::string contents_text(const Dataset& dataset) {
  std::vector<Sum> sums;
  for (const Manifest& shard : dataset.shards)
    for (const ShardFile& file : shard.files)
      sums.push_back({file.name.substr(0, file.name.rfind('.')), file.content.sha256});
  return sums_text(std::move(sums));
}

std::string dataset_text(const Dataset& dataset) {
  const std::string content = digest::digest_of(contents_text(dataset)).sha256;
  const Json json = {
      {"schema", "fathom/golden-dataset/1"},
      {"name", "fathom golden data " + std::string(name_of(dataset.level))},
      {"version", dataset.version},
      {"licence", "CC0-1.0"},
      {"generator",
       Json{{"name", "fathom"}, {"data_version", dataset.version}, {"seed", std::to_string(dataset.seed)}}},
      {"level", name_of(dataset.level)},
      {"cite",
       fmt::format("The fathom developers: fathom golden data {}, version {}, seed {}. CC0-1.0. Content SHA-256: {}",
                   name_of(dataset.level), dataset.version, dataset.seed, content)},
      {"content_sha256", content},
      {"recipes", total(dataset, &Manifest::recipes)},
      {"records", records_in(dataset)},
      {"schemas", Json{{"dataset.json", "dataset.schema.json"},
                       {"golden-*.json", "shard.schema.json"},
                       {"golden-*.jsonl.zst", "golden.schema.json"}}},
      {"shards", Json::array_of(dataset.shards, manifest_json)}};
  return json.indented() + '\n';
}

std::optional<Dataset> parse_dataset(std::string_view text) {
  try {
    const JsonValue json = text::parsed_json(text);
    Dataset dataset;
    dataset.level = find_level(json.at("level").string()).value();
    dataset.version = json.at("version").string();
    dataset.seed = std::stoull(json.at("generator").at("seed").string());
    for (const JsonValue& shard : json.at("shards").items()) dataset.shards.push_back(manifest_of(shard));
    if (dataset_text(dataset) == text) return dataset;
  } catch (const std::exception&) {  // the text is no JSON, or has other fields than a dataset
  }
  return std::nullopt;
}

// ---- agreement.json ----

std::string agreement_text(const Agreement& agreement) {
  const Json json = {{"schema", "fathom/golden-agreement/2"},
                     {"content_sha256", agreement.content_sha256},
                     {"records", agreement.records},
                     {"methods", Json::array_of(agreement.methods, [](Method method) { return Json(name(method)); })}};
  return json.indented() + '\n';
}

std::optional<Agreement> parse_agreement(std::string_view text) {
  try {
    const JsonValue json = text::parsed_json(text);
    Agreement agreement{json.at("content_sha256").string(), json.at("records").natural(), {}};
    for (const JsonValue& method : json.at("methods").items())
      agreement.methods.push_back(solve::second_method(method.string()).value());
    if (!agreement.methods.empty() && agreement_text(agreement) == text) return agreement;
  } catch (const std::exception&) {  // the text is no JSON, or has other fields than an agreement
  }
  return std::nullopt;
}

// ---- the folder ----

std::vector<std::pair<std::string, std::string>> fixed_pages() {
  return {{"LICENSE", std::string(licence())},
          {"NOTES.md", std::string(notes())},
          {"dataset.schema.json", std::string(dataset_schema())},
          {"golden.schema.json", std::string(record_schema())},
          {"shard.schema.json", std::string(shard_schema())}};
}

std::set<std::string> release_names(const std::vector<ShardPlan>& shards) {
  std::set<std::string> names = {std::string(dataset_name), std::string(contents_name), std::string(sums_name)};
  for (const auto& [name, text] : fixed_pages()) names.insert(name);
  for (const ShardPlan& shard : shards) {
    names.insert(shard.name + std::string(manifest_suffix));
    for (const std::string_view suffix : suffixes_of(shard.level)) names.insert(shard.name + std::string(suffix));
  }
  return names;
}

// ---- generation ----

namespace {

constexpr std::size_t recipes_in_flight = 32;  // for each thread; bounds the memory

/// Makes recipe after recipe of several shards on all threads; one thread at a time writes the
/// records, in order.
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
        tbb::make_filter<void, Given>(filter_mode::serial_in_order,
                                      [this](tbb::flow_control& control) { return next(control); }) &
            tbb::make_filter<Given, Records>(filter_mode::parallel, [this](Given given) { return made(*given); }) &
            tbb::make_filter<Records, void>(filter_mode::serial_in_order,
                                            [this](const Records& records) { write(*records); }));
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
  std::vector<Recipe> recipes_;  // of the current shard; like the next line, for the first stage only
  std::size_t given_shard_ = 0, given_recipe_ = 0;
  std::size_t written_shard_ = 0, written_recipe_ = 0;  // what was written last
  std::optional<ShardWriter> writer_;
  tbb::enumerable_thread_specific<Workspace> workspaces_;
  Done done_;
};

unsigned threads_of(const GenerateOptions& options) {
  return options.jobs > 0 ? options.jobs : static_cast<unsigned>(tbb::this_task_arena::max_concurrency());
}

}  // namespace

Generation::Generation(GenerateOptions options)
    : options_(std::move(options)), shards_(plan(options_.level, options_.seed)) {
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
