// SPDX-License-Identifier: GPL-3.0-or-later
// Files of one Zstandard frame, written and read as streams. The frame carries a checksum; compression runs on one thread at a fixed
// level, so the bytes are a function of the content and of the version of libzstd.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "verify/digest/sha256.hpp"
#include "verify/golden/io/files.hpp"

namespace fathom::golden {

inline constexpr int compression_level = 6;

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
  void commit() { file_.commit(); }

  [[nodiscard]] const std::string& name() const { return file_.name(); }
  /// Digests of the file and of its content. Call each once, after finish().
  digest::Digest of_file() { return file_sum_.digest(); }
  digest::Digest of_content() { return content_sum_.digest(); }

 private:
  struct Frame;
  void compress(std::string_view content, bool last);
  NewFile file_;
  std::unique_ptr<Frame> frame_;
  digest::Sha256 file_sum_, content_sum_;
};

/// Reads the content line by line. Memory is bounded by the longest line, and its length by a limit.
class ZstdReader {
 public:
  explicit ZstdReader(const std::filesystem::path& path);
  ~ZstdReader();

  /// Returns the next line without its line feed, valid until the next call, or nullopt at the end. Throws FileError, with a sentence that
  /// follows the file's name, if there is no frame, if it is cut off, damaged or followed by anything, or if the last line has no line
  /// feed.
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
