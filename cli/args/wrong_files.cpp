// SPDX-License-Identifier: GPL-3.0-or-later
// Which files of a command line stand in the way of each other: decided before any is opened.

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/args/values.hpp"
#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "reference/files/piece_files.hpp"

namespace fathom::cli {
namespace {

namespace fs = std::filesystem;

/// A file that is there, by its device and number; or the place where one is to be.
class FilePlace {
 public:
  explicit FilePlace(const std::string& path) {
    struct stat found {};
    const bool there = ::stat(path.c_str(), &found) == 0;
    if (there) take(found);
    std::error_code fault;
    path_ = fs::weakly_canonical(path, fault);
    if (fault) path_ = fs::absolute(path, fault).lexically_normal();
    if (!path_.has_filename()) path_ = path_.parent_path();  // "folder/"
  }
  /// That of an open stream.
  explicit FilePlace(int descriptor) {
    struct stat found {};
    if (::fstat(descriptor, &found) == 0) take(found);
    else special_ = true;
  }

  /// What is written into a device or a pipe destroys nothing.
  [[nodiscard]] bool is(const FilePlace& other) const {
    if (special_ || other.special_) return false;
    return id_ || other.id_ ? id_ == other.id_ : path_ == other.path_;
  }
  /// Whether it is there, and holds text or the like.
  [[nodiscard]] bool is_file() const { return regular_; }
  /// Whether it lies in that folder, not deeper.
  [[nodiscard]] bool is_in(const FilePlace& folder) const {
    return !path_.empty() && path_.parent_path() == folder.path_;
  }
  /// Whether it is named like a file that goes into folders.
  [[nodiscard]] bool has_chosen_name() const {
    const std::string ending = path_.extension().string();
    return ending == ".cert" || ending == ".svg" || ending == ".cpp" ||
           path_.filename().string().ends_with(".case.json");
  }

 private:
  void take(const struct stat& found) {
    special_ = !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode);
    regular_ = S_ISREG(found.st_mode);
    id_.emplace(found.st_dev, found.st_ino);
  }

  std::optional<std::pair<dev_t, ino_t>> id_;
  fs::path path_;
  bool special_ = false, regular_ = false;
};

/// A file of the command line.
struct NamedFile {
  std::string option, value;  // of positional words no option
  FilePlace place;
  FileUse use;

  [[nodiscard]] bool is_read() const { return use == FileUse::read || use == FileUse::read_list; }
};

/// The files of a folder of pieces, which are read too.
std::vector<std::string> files_in(const std::string& folder) {
  try {
    return files::is_folder(folder) ? files::piece_files(folder) : std::vector<std::string>();
  } catch (const InputError&) {  // who reads it will say so
    return {};
  }
}

std::vector<NamedFile> files_of(const Given& given) {
  std::vector<NamedFile> found;
  for (const GivenOption& option : given.options) {
    const bool is_input = option.option->is_input();
    if (!is_input && option.option->use == FileUse::none) continue;
    const FileUse use = is_input ? FileUse::read : option.option->use;
    const std::string name = is_input ? "" : option.name;
    for (std::string value : option.values) {
      if (name.starts_with("--pose")) {
        if (!value.starts_with('@')) continue;
        value.erase(0, 1);
      }
      if (value == "-" && use == FileUse::read) found.push_back({name, "standard input", FilePlace(STDIN_FILENO), use});
      else found.push_back({name, value, FilePlace(value), use});
      if (use != FileUse::read) continue;
      for (const std::string& file : files_in(value)) found.push_back({name, file, FilePlace(file), use});
    }
  }
  found.push_back({"standard output", "standard output", FilePlace(STDOUT_FILENO), FileUse::written});
  return found;
}

/// Whether writing the first would destroy the second.
bool destroys(const NamedFile& writes, const NamedFile& other, bool stream) {
  if (writes.use == FileUse::written_list && other.use == FileUse::read_list) return false;
  const bool folder =
      writes.use == FileUse::folder || (writes.use == FileUse::placed && stream && !writes.place.is_file());
  if (folder && other.is_read() && other.place.is_in(writes.place) && other.place.has_chosen_name()) return true;
  return writes.place.is(other.place) && !(folder && other.use == FileUse::placed);
}

/// Whether it would replace what is named like an input.
bool replaces_a_body(const NamedFile& writes) {
  const bool replaces = writes.use == FileUse::written || writes.use == FileUse::placed;
  return replaces && writes.place.is_file() && (is_mesh_name(writes.value) || is_cases_name(writes.value));
}

}  // namespace

std::string wrong_files(const Given& given, bool stream) {
  const std::vector<NamedFile> files = files_of(given);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const NamedFile& writes = files[i];
    if (writes.is_read()) continue;
    if (replaces_a_body(writes))
      return fmt::format(
          "{} would write over {}, which is named like a mesh or like cases: name another file, or remove it first",
          writes.option, kernels::shown(writes.value));
    for (std::size_t k = 0; k < files.size(); ++k) {
      const NamedFile& other = files[k];
      if (k == i || (!other.is_read() && k < i) || !destroys(writes, other, stream)) continue;
      if (!other.is_read())
        return fmt::format("{} and {} write to one place, {}: each needs its own", writes.option, other.option,
                           kernels::shown(writes.value));
      return fmt::format("{} would write over {}, which is read", writes.option, kernels::shown(other.value));
    }
  }
  return "";
}

}  // namespace fathom::cli
