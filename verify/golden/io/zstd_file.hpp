// SPDX-License-Identifier: GPL-3.0-or-later
// Files of one Zstandard frame, written and read as streams. The frame carries a checksum; compression runs on one thread at a fixed
// level, so the bytes are a function of the content and of the version of libzstd.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "verify/golden/io/input_file.hpp"
#include "verify/golden/io/new_file.hpp"
#include "verify/golden/io/sha256.hpp"

namespace fathom::golden {

inline constexpr int compression_level = 6;

/// "1.5.4": of the library that this program runs with.
std::string zstd_version();

class ZstdWriter {
 public:
  /// Throws FileError, here and below.
  ZstdWriter(const std::filesystem::path& folder, std::string name);
  ~ZstdWriter();
  void write(std::string_view content);
  /// Ends the frame and brings it to the disk; commit() gives it its name.
  void finish();
  void commit() { file_.commit(); }

  [[nodiscard]] const std::string& name() const { return file_.name(); }
  /// Of the file, and of the content. After finish(), once each.
  Digest of_file() { return file_sum_.digest(); }
  Digest of_content() { return content_sum_.digest(); }

 private:
  struct Frame;
  void compress(std::string_view content, bool last);
  NewFile file_;
  std::unique_ptr<Frame> frame_;
  Sha256 file_sum_, content_sum_;
};

/// Hands out the content line by line. Whatever a file holds, memory is bounded by its longest line, and that by a limit.
class ZstdReader {
 public:
  explicit ZstdReader(const std::filesystem::path& path);
  ~ZstdReader();

  /// The next line without its line feed, until the next call; nothing at the end. Throws FileError, with a sentence that follows the
  /// file's name, where the frame is cut off or damaged, is followed by anything, is no frame, or where the last line has no line feed.
  std::optional<std::string_view> line();
  /// The number of the line that was handed out last, from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Of all content. After the end.
  Digest of_content() { return content_sum_.digest(); }

 private:
  struct Frame;
  bool more();
  InputFile file_;
  std::unique_ptr<Frame> frame_;
  Sha256 content_sum_;
  std::string text_;
  std::size_t begin_ = 0, number_ = 0;
  bool ended_ = false;
};

}  // namespace fathom::golden
