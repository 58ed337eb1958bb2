// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all: beyond files::WholeFile it is synced to disk, and no other process can write it meanwhile.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fathom::golden {

/// How hidden names begin and end: ".new-" name. A killed process leaves such files behind; the next one overwrites them.
inline constexpr std::string_view hidden_prefix = ".new-";

class NewFile {
 public:
  /// Throws FileError, also if another living process is writing the same file.
  NewFile(std::filesystem::path folder, std::string name);
  /// Removes the hidden file unless it was committed.
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Throws FileError.
  void write(std::string_view bytes);
  /// Syncs all bytes to disk. Throws FileError.
  void sync();
  /// Gives the file its name. Call sync() first. Throws FileError.
  void commit();

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::filesystem::path hidden_, final_;
  std::string name_;
  int descriptor_ = -1;
  bool committed_ = false;
};

/// Syncs the names in a folder to disk. Throws FileError.
void sync_folder(const std::filesystem::path& folder);

/// Writes a small file, whole or not at all. Does nothing if it has this content already.
void put_file(const std::filesystem::path& folder, const std::string& name, std::string_view content);

}  // namespace fathom::golden
