// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a release: read block by block, written whole by files::WholeFile, compressed; and
// errors.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "reference/files/file_io.hpp"
#include "verify/digest/sha256.hpp"

namespace fathom::golden {

using files::FileError;

/// The folder holds something else than the release: shards of another seed, or other files.
struct FolderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

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

/// The prefix of hidden names: ".new-" name. A killed process leaves such files behind; the next
/// one overwrites them.
inline constexpr std::string_view hidden_prefix = ".new-";

/// Syncs the names in a folder to disk. Throws FileError.
void sync_folder(const std::filesystem::path& folder);

/// Writes a small file, whole or not at all. Does nothing if it has this content already.
void put_file(const std::filesystem::path& folder, const std::string& name, std::string_view content);

// ---- Zstandard ----

// Files of one Zstandard frame, written and read as streams. The frame carries a checksum;
// compression runs on one thread at a fixed level, so the bytes are a function of the content and
// of the version of libzstd.

/// Returns the version of the library that this program runs with: "1.5.4".
std::string zstd_version();

class ZstdWriter {
 public:
  /// Throws FileError, here and below.
  ZstdWriter(const std::filesystem::path& folder, std::string name);
  ~ZstdWriter();
  void write(std::string_view content);
  /// Ends the frame and syncs it to disk; commit() gives it its name.
  void finish();
  void commit() { file_.put_in_place(); }

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Digests of the file and of its content. Call each once, after finish().
  digest::Digest of_file() { return file_sum_.digest(); }
  digest::Digest of_content() { return content_sum_.digest(); }

 private:
  struct Frame;
  void compress(std::string_view content, bool last);
  std::string name_;
  files::WholeFile file_;
  std::unique_ptr<Frame> frame_;
  digest::Sha256 file_sum_, content_sum_;
};

/// Reads the content line by line. Memory is bounded by the longest line, and its length by a
/// limit.
class ZstdReader {
 public:
  explicit ZstdReader(const std::filesystem::path& path);
  ~ZstdReader();

  /// Returns the next line without its line feed, valid until the next call, or nullopt at the end.
  /// Throws FileError, with a sentence that follows the file's name, if there is no frame, if it is
  /// cut off, damaged or followed by anything, or if the last line has no line feed.
  std::optional<std::string_view> line();
  /// The number of the line that was returned last, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// The digest of all content. Call it after the end.
  digest::Digest of_content() { return content_sum_.digest(); }

 private:
  struct Frame;
  bool more();
  InputFile file_;
  std::unique_ptr<Frame> frame_;
  digest::Sha256 content_sum_;
  std::string text_;
  std::size_t begin_ = 0, number_ = 0;
  bool ended_ = false;
};

}  // namespace fathom::golden
