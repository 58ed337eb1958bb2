// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/export/export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "kernels/context.hpp"
#include "verify/golden/export/spread.hpp"
#include "verify/golden/io/file_error.hpp"
#include "verify/golden/io/input_file.hpp"
#include "verify/golden/io/zstd_file.hpp"
#include "verify/golden/records/flags.hpp"
#include "verify/golden/records/record_reader.hpp"
#include "verify/golden/release/dataset.hpp"

namespace fathom::golden {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view statuses[] = {"penetrating", "touching", "disjoint"};

std::string_view first_word(std::string_view flag) { return flag.substr(0, flag.find('_')); }

Dataset dataset_in(const fs::path& folder) {
  const fs::path page = folder / dataset_name;
  std::optional<Dataset> dataset = parse_dataset(read_small_file(page));
  if (!dataset) throw FileError(page.string() + ": this is not the page of a release");
  if (const Kind kind = kind_of(dataset->level); kind != Kind::polytopes)
    throw FolderError(fmt::format("{} holds {}, and exports are of polytopes: levels L0 to L3", folder.string(),
                                  kind == Kind::shapes ? "shapes" : "unions"));
  return *std::move(dataset);
}

/// The records of a release, one after another.
class Records {
 public:
  Records(fs::path folder, const Dataset& dataset, Monitor* monitor) : folder_(std::move(folder)), dataset_(&dataset), monitor_(monitor) {}

  /// Calls `take` with each; nullopt for one that doubles cannot tell.
  template <class Take>
  void each(Take take) const {
    for (const Manifest& shard : dataset_->shards) {
      const ShardFile& file = shard.files.front();
      ZstdReader reader(folder_ / file.name);
      try {
        while (const std::optional<std::string_view> line = reader.line()) {
          kernels::Context(monitor_).check();
          take(export_case(*line));
        }
        if (reader.of_content() != file.content) throw FileError("the content is not what the shard's page says");
      } catch (const FileError& error) {
        throw FileError(fmt::format("{}: {}", (folder_ / file.name).string(), error.what()));
      } catch (const NotARecord& error) {
        throw FileError(fmt::format("{}:{}: {}", (folder_ / file.name).string(), reader.number(), error.what()));
      }
    }
  }

 private:
  fs::path folder_;
  const Dataset* dataset_;
  Monitor* monitor_;
};

/// Whether a case fits; counts why not.
bool fits(const std::optional<ExportCase>& entry, const ExportRequest& request, Exported& counts) {
  ++counts.records;
  if (!entry) return ++counts.not_doubles, false;
  if (std::ranges::any_of(request.excluded, [&](const std::string& word) { return excludes(word, *entry); }))
    return ++counts.excluded, false;
  if (std::max(entry->a.size(), entry->b.size()) > request.most_points) return ++counts.too_large, false;
  return ++counts.fitting, true;
}

/// The numbers of the chosen ones among those that fit. `groups`: of each group, the numbers of those in it.
std::set<std::size_t> chosen_of(const std::vector<std::vector<std::size_t>>& groups, std::size_t count) {
  std::vector<std::size_t> sizes;
  for (const std::vector<std::size_t>& group : groups) sizes.push_back(group.size());
  const std::vector<std::size_t> parts = shares(sizes, count);
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (const std::size_t at : evenly(parts[i], sizes[i])) chosen.insert(groups[i][at]);
  return chosen;
}

/// Groups in the order in which they are first met.
class Groups {
 public:
  void add(const std::string& name, std::size_t number) {
    const std::size_t group = places_.try_emplace(name, groups_.size()).first->second;
    if (group == groups_.size()) groups_.emplace_back();
    groups_[group].push_back(number);
  }
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& all() const { return groups_; }

 private:
  std::map<std::string, std::size_t> places_;
  std::vector<std::vector<std::size_t>> groups_;
};

void refuse_if_none_fits(const fs::path& folder, const Exported& counts) {
  if (counts.fitting > 0) return;
  throw FolderError(fmt::format("none of the {} records of {} fits: {} are beyond binary64, {} are excluded, {} have more points",
                                counts.records, folder.string(), counts.not_doubles, counts.excluded, counts.too_large));
}

}  // namespace

std::vector<std::string> excludable() {
  std::set<std::string> words(std::begin(statuses), std::end(statuses));
  for (const std::string_view flag : flag_names()) {
    words.emplace(flag);
    words.emplace(first_word(flag));
  }
  return {words.begin(), words.end()};
}

bool excludes(std::string_view word, const ExportCase& entry) {
  return word == entry.status ||
         std::ranges::any_of(entry.flags, [word](const std::string& flag) { return word == flag || word == first_word(flag); });
}

std::string command_of(const ExportRequest& request) {
  std::string command = fmt::format("fathom golden export --format {}", name_of(request.format));
  if (!request.excluded.empty()) command += fmt::format(" --exclude {}", fmt::join(request.excluded, ","));
  if (request.most_points != SIZE_MAX) command += fmt::format(" --max-points {}", request.most_points);
  if (request.count != SIZE_MAX) command += fmt::format(" --count {}", request.count);
  return command;
}

Exported export_release(const fs::path& folder, const ExportRequest& request, Monitor* monitor) {
  const Dataset dataset = dataset_in(folder);
  const Records records(folder, dataset, monitor);
  Groups groups;
  Exported result;
  records.each([&](const std::optional<ExportCase>& entry) {
    if (fits(entry, request, result)) groups.add(entry->group, result.fitting - 1);
  });
  refuse_if_none_fits(folder, result);

  const std::set<std::size_t> chosen = chosen_of(groups.all(), request.count);
  std::vector<ExportCase> cases;
  Exported again;
  records.each([&](std::optional<ExportCase> entry) {
    if (fits(entry, request, again) && chosen.count(again.fitting - 1) > 0) cases.push_back(*std::move(entry));
  });
  result.chosen = cases.size();
  result.text = export_text(
      request.format, {std::string(name_of(dataset.level)), dataset.version, std::to_string(dataset.seed), command_of(request)}, cases);
  return result;
}

}  // namespace fathom::golden
