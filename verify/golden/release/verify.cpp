// SPDX-License-Identifier: GPL-3.0-or-later

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/release/release.hpp"

namespace fathom::golden {
namespace fs = std::filesystem;
namespace {

/// Checks a release from the outside inwards. Each step relies on the ones before it, so the first
/// one that fails ends the verification.
class Verifier {
 public:
  Verifier(fs::path folder, const VerifyOptions& options) : folder_(std::move(folder)), options_(&options) {}

  Verified run() {
    static_cast<void>(read_dataset() && check_names() && check_sums() && check_pages() && check_shards());
    return std::move(result_);
  }

 private:
  bool refuse(std::string place, std::string reason) {
    result_.refusals.push_back({std::move(place), std::move(reason)});
    return false;
  }
  [[nodiscard]] bool accepted() const { return result_.refusals.empty(); }

  /// Returns the text of a small file, or nullopt after adding a refusal.
  std::optional<std::string> text_of(const std::string& name) {
    try {
      return read_small_file(folder_ / name);
    } catch (const FileError& error) {
      refuse(name, error.what());
      return std::nullopt;
    }
  }

  bool read_dataset() {
    list_names();
    const std::string name(dataset_name);
    if (names_.count(name) == 0) return refuse(name, "the file is missing");
    const std::optional<std::string> text = text_of(name);
    if (!text) return false;
    std::optional<Dataset> dataset = parse_dataset(*text);
    if (!dataset)
      return refuse(name, "this is not the page of a release as dataset.schema.json says and this program writes it");
    dataset_ = std::move(*dataset);
    if (dataset_.version != data_version)
      return refuse(name, "data version " + kernels::printable(dataset_.version, 40) + ", and this program knows " +
                              std::string(data_version));
    shards_ = plan(dataset_.level, dataset_.seed);
    if (shards_.size() != dataset_.shards.size())
      return refuse(
          name, std::to_string(dataset_.shards.size()) + " shards, and the plan has " + std::to_string(shards_.size()));
    for (std::size_t i = 0; i < shards_.size(); ++i)
      if (auto fault = not_of_plan(dataset_.shards[i], shards_[i], dataset_.seed))
        return refuse(name, shards_[i].name + ": " + *fault);
    result_.level = dataset_.level;
    result_.version = dataset_.version;
    result_.seed = dataset_.seed;
    result_.shards = shards_.size();
    return true;
  }

  void list_names() {
    std::error_code error;
    fs::directory_iterator entry(folder_, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error))
      names_.insert(entry->path().filename().string());
    if (error) throw FileError("read the folder", folder_, error.value());
  }

  bool check_names() {
    const std::set<std::string> expected = release_names(shards_);
    stated_ = names_.erase(std::string(agreement_name)) > 0;
    for (const std::string& name : names_)
      if (expected.count(name) == 0) refuse(kernels::printable(name, 200), "no file of this release");
    for (const std::string& name : expected)
      if (names_.count(name) == 0) refuse(name, "the file is missing");
    return accepted();
  }

  bool check_sums() {
    const std::string name(sums_name);
    const std::optional<std::string> text = text_of(name);
    if (!text) return false;
    const std::optional<std::vector<Sum>> sums = parse_sums(*text);
    if (!sums) return refuse(name, "these are not the sums of files in the order of their names");
    std::set<std::string> listed = {name};
    for (const Sum& sum : *sums) listed.insert(sum.name);
    if (listed != names_) return refuse(name, "the names are not those of all other files");
    std::vector<std::string> reasons(sums->size());
    tbb::parallel_for(std::size_t{0}, sums->size(), [&](std::size_t i) { reasons[i] = wrong_sum((*sums)[i]); });
    for (std::size_t i = 0; i < reasons.size(); ++i)
      if (!reasons[i].empty()) refuse((*sums)[i].name, reasons[i]);
    sums_.assign(sums->begin(), sums->end());
    return accepted();
  }

  std::string wrong_sum(const Sum& sum) const {
    kernels::Context(options_->monitor).check();
    try {
      return digest_of_file(folder_ / sum.name).sha256 == sum.sha256
                 ? ""
                 : "the file does not have the sum that " + std::string(sums_name) + " says";
    } catch (const FileError& error) {
      return error.what();
    }
  }

  bool check_pages() {
    for (const auto& [name, expected] : fixed_pages()) {
      const std::optional<std::string> text = text_of(name);
      if (text && *text != expected) refuse(name, "the page is not the one that goes with this version of the data");
    }
    const std::string contents(contents_name);
    if (const auto text = text_of(contents); text && *text != contents_text(dataset_))
      refuse(contents, "these are not the sums of the contents that " + std::string(dataset_name) + " says");
    for (const Manifest& shard : dataset_.shards) {
      const std::string page = shard.name + std::string(manifest_suffix);
      const std::optional<std::string> text = text_of(page);
      if (text && *text != manifest_text(shard))
        refuse(page, "the page differs from the shard's entry in " + std::string(dataset_name));
      for (const ShardFile& file : shard.files) check_listed(file);
    }
    if (stated_) check_agreement();
    return accepted();
  }

  void check_agreement() {
    const std::string name(agreement_name);
    const std::optional<std::string> text = text_of(name);
    if (!text) return;
    const std::optional<Agreement> agreement = parse_agreement(*text);
    if (!agreement) {
      refuse(name, "this is not a page as agreement.schema.json says and this program writes it");
    } else if (agreement->content_sha256 != digest_of_file(folder_ / contents_name).sha256 ||
               agreement->records != records_in(dataset_)) {
      refuse(name, "the page is about another release");
    }
  }

  /// Compares the shard's page with the sums, which have been checked already.
  void check_listed(const ShardFile& file) {
    const bool same = std::ranges::find(sums_, Sum{file.name, file.file.sha256}) != sums_.end();
    std::error_code error;
    if (!same || fs::file_size(folder_ / file.name, error) != file.file.bytes)
      refuse(file.name, "size or sum is not what the shard's page says");
  }

  bool check_shards() {
    const std::size_t all = records_in(dataset_);
    if (options_->elsewhere) {
      options_->elsewhere(shards_, [&](std::size_t, ShardResult result) {
        result_.records += result.records;
        if (options_->report) options_->report(result_.records, all);
        if (result.refusal) result_.refusals.push_back(*std::move(result.refusal));
        return accepted();
      });
      return accepted();
    }
    const ShardOptions options{options_->methods, options_->monitor, [&] {
                                 ++result_.records;
                                 if (options_->report) options_->report(result_.records, all);
                               }};
    for (std::size_t i = 0; i < shards_.size() && accepted(); ++i)
      if (auto refusal = refusal_of_shard(folder_, shards_[i], dataset_.shards[i], options))
        result_.refusals.push_back(std::move(*refusal));
    return accepted();
  }

  fs::path folder_;
  const VerifyOptions* options_;
  std::set<std::string> names_;
  bool stated_ = false;  // whether there is a page on agreement
  Dataset dataset_;
  std::vector<ShardPlan> shards_;
  std::vector<Sum> sums_;
  Verified result_;
};

}  // namespace

namespace {

/// Returns work(), run in an arena with the number of threads of the options.
template <class Work>
auto on_threads(const VerifyOptions& options, Work work) {
  const unsigned threads =
      options.jobs > 0 ? options.jobs : static_cast<unsigned>(tbb::this_task_arena::max_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(static_cast<int>(threads));
  return arena.execute(work);
}

}  // namespace

Verified verify(const fs::path& folder, const VerifyOptions& options) {
  return on_threads(options, [&] { return Verifier(folder, options).run(); });
}

ShardVerifier::ShardVerifier(fs::path folder, VerifyOptions options)
    : folder_(std::move(folder)), options_(std::move(options)) {
  std::optional<Dataset> dataset = parse_dataset(read_small_file(folder_ / dataset_name));
  if (!dataset) throw FileError((folder_ / dataset_name).string() + ": this is not the page of a release");
  dataset_ = *std::move(dataset);
  shards_ = plan(dataset_.level, dataset_.seed);
}

ShardResult ShardVerifier::verify(std::size_t shard) const {
  return on_threads(options_, [&] {
    ShardResult result;
    const ShardOptions options{options_.methods, options_.monitor, [&] { ++result.records; }};
    result.refusal = refusal_of_shard(folder_, shards_.at(shard), dataset_.shards.at(shard), options);
    return result;
  });
}

void state_agreement(const fs::path& folder, const Verified& verified, const std::vector<Method>& methods) {
  put_file(folder, std::string(agreement_name),
           agreement_text({digest_of_file(folder / contents_name).sha256, verified.records, methods}));
}

}  // namespace fathom::golden
