// SPDX-License-Identifier: GPL-3.0-or-later
// A file read block by block.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "verify/digest/sha256.hpp"

namespace fathom::golden {

class InputFile {
 public:
  /// Throws FileError if there is no regular file that can be read.
  explicit InputFile(std::filesystem::path path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Returns the next bytes, valid until the next call; none at the end. Throws FileError.
  std::string_view read();

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::string block_;
};

/// Returns the content of a small file. Throws FileError, also if it is larger than `most` bytes.
std::string read_small_file(const std::filesystem::path& path, std::size_t most = std::size_t{64} << 20);

/// Returns the digest of a file. Throws FileError if it cannot be read.
digest::Digest digest_of_file(const std::filesystem::path& path);

}  // namespace fathom::golden
