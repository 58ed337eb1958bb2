// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/golden/export/export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/context.hpp"
#include "kernels/messages.hpp"
#include "verify/families/families.hpp"
#include "verify/golden/io/files.hpp"
#include "verify/golden/records/facts.hpp"
#include "verify/golden/records/record.hpp"
#include "verify/golden/release/release.hpp"

namespace fathom::golden {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view statuses[] = {"penetrating", "touching", "disjoint"};

std::string_view first_word(std::string_view flag) { return flag.substr(0, flag.find('_')); }

Dataset dataset_in(const fs::path& folder) {
  const fs::path page = folder / dataset_name;
  std::optional<Dataset> dataset = parse_dataset(read_small_file(page));
  if (!dataset) throw FileError(page.string() + ": this is not the page of a release");
  if (const Level level = dataset->level; !of_polytopes(level) && level != Level::C0 && level != Level::F0)
    throw FolderError(
        fmt::format("{} holds {}, and a case of an export is two lists of points: export a level of L0 to L3, C0 or F0",
                    folder.string(), level == Level::U0 ? "unions" : "shapes"));
  return *std::move(dataset);
}

/// Returns whether the record is of shapes, or of the plane with a radius. Levels C0 and F0 have
/// some; exports skip them without counting.
bool is_of_shapes(std::string_view line) {
  return line.substr(0, line.find(R"("id")")).find("fathom/golden-shapes/") != std::string_view::npos ||
         line.find(R"("margin":)") != std::string_view::npos;
}

/// Iterates over the records of a release.
class ReleaseRecords {
 public:
  ReleaseRecords(fs::path folder, const Dataset& dataset, Monitor* monitor)
      : folder_(std::move(folder)), dataset_(&dataset), monitor_(monitor) {}

  /// Calls take(record, certificate) with each record. `record` is nullopt if doubles cannot
  /// represent it; certificate() reads its certificate, which is skipped unless called.
  template <class Take>
  void each(Take take) const {
    for (const Manifest& shard : dataset_->shards) {
      ZstdReader lines(folder_ / shard.files[0].name), proofs(folder_ / shard.files[1].name);
      std::size_t number = 0, proved = 0;
      const auto certificate = [&] {
        return guarded(shard.files[1], proofs, [&] {
          std::string text;
          for (; proved < number; ++proved) text = next_certificate(proofs);
          return text;
        });
      };
      guarded(shard.files[0], lines, [&] {
        while (const std::optional<std::string_view> line = lines.line()) {
          kernels::Context(monitor_).check();
          ++number;
          if (!is_of_shapes(*line)) take(export_case(*line), certificate);
        }
        expect_content(shard.files[0], lines);
      });
      if (proved == 0) continue;
      guarded(shard.files[1], proofs, [&] {
        while (proofs.line()) continue;
        expect_content(shard.files[1], proofs);
      });
    }
  }

 private:
  static std::string next_certificate(ZstdReader& proofs) {
    std::string text;
    while (const std::optional<std::string_view> line = proofs.line()) {
      (text += *line) += '\n';
      if (line->starts_with("end ")) return text;
    }
    throw FileError("a certificate is missing or cut off");
  }
  static void expect_content(const ShardFile& file, ZstdReader& reader) {
    if (reader.of_content() != file.content) throw FileError("the content is not what the shard's page says");
  }
  /// Returns action(), with file and line before the message of an error.
  template <class Action>
  auto guarded(const ShardFile& file, const ZstdReader& reader, Action action) const {
    const std::string path = (folder_ / file.name).string();
    try {
      return action();
    } catch (const FileError& error) {
      if (std::string_view(error.what()).find(folder_.string()) != std::string_view::npos)
        throw;  // the message has the file's name already
      throw FileError(fmt::format("{}: {}", path, error.what()));
    } catch (const NotARecord& error) {
      throw FileError(fmt::format("{}:{}: {}", path, reader.number(), error.what()));
    }
  }

  fs::path folder_;
  const Dataset* dataset_;
  Monitor* monitor_;
};

/// The user's own cases, with answers and certificates computed here instead of read from a
/// release.
class OwnRecords {
 public:
  OwnRecords(const std::string& path, Monitor* monitor) {
    std::set<std::string> names;
    std::optional<unsigned> dimension;
    CaseStream cases = CaseStream::open(path, std::cin);
    const std::string name = path == "-" ? "<stdin>" : path;
    while (const std::optional<CaseItem> item = cases.next()) {
      const auto wrong = [&](const std::string& sentence) { return InputError(name, item->line, sentence); };
      if (!item->ok()) throw item->error();
      if (!is_plain(item->id))
        throw wrong("expected an id of letters, digits and . _ - alone, found " + kernels::shown(item->id));
      if (!names.insert(item->id).second) throw wrong("the id " + kernels::shown(item->id) + " occurred before");
      const Case& points = item->value();
      for (const Body* body : {&points.a, &points.b}) {
        if (body->dimension != dimension.value_or(body->dimension))
          throw wrong("expected bodies that are all of the plane or all of space, found both");
        dimension = body->dimension;
        if (body->shape || body->pieces)
          throw wrong("expected vertices, found a shape or pieces: a case of an export is two lists of points");
      }
      RecordBodies bodies = HullPair{points.a, points.b};
      if (dimension == 2) bodies = plane_of(points);
      const Record record =
          record_of({Source::real, item->id, 0, 0}, {Form::given, item->id, std::move(bodies)}, monitor);
      std::optional<ExportCase> entry = export_case(record.line);
      if (entry) entry->group = "own";
      all_.push_back({std::move(entry), record.certificate});
    }
  }

  template <class Take>
  void each(Take take) const {
    for (const Own& own : all_) take(own.entry, [&own] { return own.certificate; });
  }

 private:
  struct Own {
    std::optional<ExportCase> entry;
    std::string certificate;
  };
  static bool is_plain(const std::string& id) {
    return !id.empty() && std::ranges::all_of(id, [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-';
    });
  }

  std::vector<Own> all_;
};

/// Returns whether the word is the status, one of the flags, or the first word of a flag: "flat"
/// for flat_a.
bool has_word(std::string_view word, const ExportCase& entry) {
  return word == entry.status || std::ranges::any_of(entry.flags, [word](const std::string& flag) {
           return word == flag || word == first_word(flag);
         });
}

/// Returns whether the request selects the case.
bool is_wanted(const ExportCase& entry, const ExportRequest& request) {
  const auto has = [&entry](const std::string& word) { return has_word(word, entry); };
  const auto named = [&entry](const std::string& pattern) {
    return ::fnmatch(pattern.c_str(), entry.group.c_str(), 0) == 0;
  };
  const auto met = [&entry](const std::string& kind) {
    return std::ranges::find(entry.contacts, kind) != entry.contacts.end();
  };
  const bool exact =
      request.exact_in.empty() || std::ranges::find(entry.formats, request.exact_in) != entry.formats.end();
  return !std::ranges::any_of(request.excluded, has) &&
         (request.only.empty() || std::ranges::any_of(request.only, has)) &&
         (request.families.empty() || std::ranges::any_of(request.families, named)) &&
         (request.contacts.empty() || std::ranges::any_of(request.contacts, met)) && exact;
}

/// Returns whether a case fits the request; counts the reason if not.
bool fits(const std::optional<ExportCase>& entry, const ExportRequest& request, Exported& counts) {
  ++counts.records;
  if (!entry) return ++counts.not_doubles, false;
  if (!is_wanted(*entry, request)) return ++counts.excluded, false;
  if (std::max(entry->a.size(), entry->b.size()) > request.most_points) return ++counts.too_large, false;
  return ++counts.fitting, true;
}

/// Returns `count` <= `size` numbers below `size`, ascending and evenly spaced.
std::vector<std::size_t> evenly(std::size_t count, std::size_t size) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back((2 * i + 1) * size / (2 * count));  // the middle of each of `count` parts
  return result;
}

/// Returns how many cases to take of each group, of which `sizes` are available: `count` in all, or
/// all if they are fewer. Groups that are not exhausted differ by one at most; those that get the
/// additional one are evenly spaced.
std::vector<std::size_t> shares(const std::vector<std::size_t>& sizes, std::size_t count) {
  std::vector<std::size_t> result(sizes.size(), 0);
  while (count > 0) {
    std::vector<std::size_t> open;
    for (std::size_t group = 0; group < sizes.size(); ++group)
      if (result[group] < sizes[group]) open.push_back(group);
    if (open.empty()) break;
    const std::size_t round = count < open.size() ? count : open.size();
    for (const std::size_t i : evenly(round, open.size())) ++result[open[i]];
    count -= round;
  }
  return result;
}

/// Returns the numbers of the chosen cases. `groups`: for each group, the numbers of its cases that
/// fit.
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
  throw FolderError(
      fmt::format("none of the {} records of {} fits: {} are beyond binary64, {} are excluded, {} have more points",
                  counts.records, folder.string(), counts.not_doubles, counts.excluded, counts.too_large));
}

/// Returns the command line that repeats the export, without the folder or file.
std::string command_of(const ExportRequest& request) {
  std::string command = fmt::format("fathom golden export --format {}", name_of(request.format));
  const auto add = [&command](std::string_view option, const std::vector<std::string>& words) {
    if (!words.empty()) command += fmt::format(" {} {}", option, fmt::join(words, ","));
  };
  add("--only", request.only);
  add("--exclude", request.excluded);
  add("--family", request.families);
  add("--contact", request.contacts);
  if (!request.exact_in.empty()) add("--exact-in", {request.exact_in});
  if (request.most_points != SIZE_MAX) command += fmt::format(" --max-points {}", request.most_points);
  if (request.count != SIZE_MAX) command += fmt::format(" --count {}", request.count);
  return command;
}

}  // namespace

std::vector<std::string> words_of_cases() {
  std::set<std::string> words(std::begin(statuses), std::end(statuses));
  for (const std::string_view flag : flag_names()) {
    words.emplace(flag);
    words.emplace(first_word(flag));
  }
  return {words.begin(), words.end()};
}

std::vector<std::string> groups_of_releases() {
  std::vector<std::string> names = {"catalogue", "real"};
  for (const families::Kind kind : {families::Kind::polytopes, families::Kind::plane})
    for (const families::Family& family : families::families(kind))
      if (family.name != "catalogue") names.emplace_back(family.name);
  return names;
}

namespace {

/// Reads `records` twice, so that memory is bounded by the size of the export.
template <class Records>
Exported exported(const Records& records, const fs::path& from, const ExportRequest& request,
                  const ExportSource& source) {
  Groups groups;
  Exported result;
  records.each([&](const std::optional<ExportCase>& entry, const auto&) {
    if (fits(entry, request, result)) groups.add(entry->group, result.fitting - 1);
  });
  refuse_if_none_fits(from, result);

  const std::set<std::size_t> chosen = chosen_of(groups.all(), request.count);
  std::vector<ExportCase> cases;
  Exported again;
  records.each([&](std::optional<ExportCase> entry, const auto& certificate) {
    if (!fits(entry, request, again) || chosen.count(again.fitting - 1) == 0) return;
    cases.push_back(*std::move(entry));
    if (request.certificates) result.certificates += certificate();
  });
  result.chosen = cases.size();
  result.text = export_text(request.format, source, cases);
  return result;
}

/// Returns the name of a file without its folder, escaped so that comments and JSON can hold it.
std::string plain_name(const std::string& path) {
  std::string name = path == "-" ? "standard input" : fs::path(path).filename().string();
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && std::string_view(" ._-").find(c) == std::string_view::npos)
      c = '_';
  return name;
}

}  // namespace

Exported export_release(const fs::path& folder, const ExportRequest& request, Monitor* monitor) {
  const Dataset dataset = dataset_in(folder);
  return exported(
      ReleaseRecords(folder, dataset, monitor), folder, request,
      {std::string(name_of(dataset.level)), dataset.version, std::to_string(dataset.seed), "", command_of(request)});
}

Exported export_own_cases(const std::string& path, const ExportRequest& request, Monitor* monitor) {
  return exported(OwnRecords(path, monitor), path, request, {"", "", "", plain_name(path), command_of(request)});
}

}  // namespace fathom::golden
