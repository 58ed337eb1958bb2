// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong with files of a release, by whose fault it is.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace fathom::golden {

/// The system refused: full disk, no permission, a file that cannot be read.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
  /// "cannot `action` `path`: " and the system's words for the error `code` (an errno).
  FileError(const std::string& action, const std::filesystem::path& path, int code);
};

/// The folder holds something else than the user seems to think: the shards of another seed, files of his own.
struct FolderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fathom::golden
