// SPDX-License-Identifier: GPL-3.0-or-later
// Errors with the files of a release: the system's, and the user's.
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

/// The folder holds something else than the release: shards of another seed, or other files.
struct FolderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace fathom::golden
