// SPDX-License-Identifier: GPL-3.0-or-later

#include "verify/golden/io/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <cerrno>
#include <new>
#include <utility>

namespace fathom::golden {

// ---- reading ----

namespace {

constexpr int compression_level = 6;

constexpr std::size_t block_size = std::size_t{1} << 18;

}  // namespace

InputFile::InputFile(std::filesystem::path path) : path_(std::move(path)), block_(block_size, '\0') {
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
  if (descriptor_ < 0) throw FileError("open", path_, errno);
  struct stat status = {};
  if (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) return;
  ::close(descriptor_);
  throw FileError("cannot read " + path_.string() + ": no regular file");
}

InputFile::~InputFile() { ::close(descriptor_); }

std::string_view InputFile::read() {
  for (;;) {
    const ssize_t count = ::read(descriptor_, block_.data(), block_.size());
    if (count >= 0) return std::string_view(block_).substr(0, static_cast<std::size_t>(count));
    if (errno != EINTR) throw FileError("read", path_, errno);
  }
}

std::string read_small_file(const std::filesystem::path& path, std::size_t most) {
  InputFile file(path);
  std::string text;
  for (std::string_view block = file.read(); !block.empty(); block = file.read()) {
    text += block;
    if (text.size() > most) throw FileError("cannot read " + path.string() + ": larger than expected");
  }
  return text;
}

digest::Digest digest_of_file(const std::filesystem::path& path) {
  InputFile file(path);
  digest::Sha256 sum;
  for (std::string_view block = file.read(); !block.empty(); block = file.read()) sum.add(block);
  return sum.digest();
}

// ---- writing ----

void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
  if (descriptor < 0) throw FileError("open", folder, errno);
  const int code = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (code != 0 && code != EINVAL) throw FileError("write", folder, code);
}

void put_file(const std::filesystem::path& folder, const std::string& name, std::string_view content) {
  if (std::filesystem::is_regular_file(folder / name) && std::filesystem::file_size(folder / name) == content.size() &&
      read_small_file(folder / name) == content)
    return;
  files::WholeFile file(folder / name, std::string(hidden_prefix) + name);
  file.write(content);
  file.sync();
  file.put_in_place();
  sync_folder(folder);
}

// ---- Zstandard ----

namespace {

std::size_t checked(std::size_t code) {
  if (ZSTD_isError(code)) throw FileError(std::string("the Zstandard frame is damaged: ") + ZSTD_getErrorName(code));
  return code;
}

}  // namespace

std::string zstd_version() { return ZSTD_versionString(); }

struct ZstdWriter::Frame {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  std::string out = std::string(ZSTD_CStreamOutSize(), '\0');
  Frame() {
    if (!context) throw std::bad_alloc();
    ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, compression_level);
    ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  }
  ~Frame() { ZSTD_freeCCtx(context); }
};

ZstdWriter::ZstdWriter(const std::filesystem::path& folder, std::string name)
    : name_(std::move(name)),
      file_(folder / name_, std::string(hidden_prefix) + name_),
      frame_(std::make_unique<Frame>()) {}

ZstdWriter::~ZstdWriter() = default;

void ZstdWriter::write(std::string_view content) {
  content_sum_.add(content);
  compress(content, false);
}

void ZstdWriter::finish() {
  compress({}, true);
  file_.sync();
}

void ZstdWriter::compress(std::string_view content, bool last) {
  ZSTD_inBuffer in{content.data(), content.size(), 0};
  for (bool done = false; !done;) {
    ZSTD_outBuffer out{frame_->out.data(), frame_->out.size(), 0};
    const std::size_t left =
        checked(ZSTD_compressStream2(frame_->context, &out, &in, last ? ZSTD_e_end : ZSTD_e_continue));
    const std::string_view made = std::string_view(frame_->out).substr(0, out.pos);
    file_sum_.add(made);
    file_.write(made);
    done = last ? left == 0 : in.pos == in.size;
  }
}

struct ZstdReader::Frame {
  ZSTD_DCtx* context = ZSTD_createDCtx();
  std::string_view block;  // of the file, not yet decompressed
  std::string out = std::string(ZSTD_DStreamOutSize(), '\0');
  bool complete = false;
  Frame() {
    if (!context) throw std::bad_alloc();
  }
  ~Frame() { ZSTD_freeDCtx(context); }
};

ZstdReader::ZstdReader(const std::filesystem::path& path) : file_(path), frame_(std::make_unique<Frame>()) {}

ZstdReader::~ZstdReader() = default;

/// Appends the next piece of content to text_; returns false at the end.
bool ZstdReader::more() {
  Frame& frame = *frame_;
  for (;;) {
    if (frame.block.empty()) frame.block = file_.read();
    if (frame.complete) {
      if (!frame.block.empty()) throw FileError("something follows the Zstandard frame");
      return false;
    }
    const bool at_end = frame.block.empty();
    ZSTD_inBuffer in{frame.block.data(), frame.block.size(), 0};
    ZSTD_outBuffer out{frame.out.data(), frame.out.size(), 0};
    frame.complete = checked(ZSTD_decompressStream(frame.context, &out, &in)) == 0;
    frame.block.remove_prefix(in.pos);
    if (at_end && out.pos == 0 && !frame.complete) throw FileError("the Zstandard frame is cut off");
    if (out.pos == 0) continue;
    const std::string_view piece = std::string_view(frame.out).substr(0, out.pos);
    content_sum_.add(piece);
    text_.erase(0, std::exchange(begin_, 0));
    text_ += piece;
    return true;
  }
}

std::optional<std::string_view> ZstdReader::line() {
  std::size_t seen = begin_;
  while (!ended_) {
    const std::size_t end = text_.find('\n', seen);
    if (end != std::string::npos) {
      ++number_;
      const std::size_t begin = std::exchange(begin_, end + 1);
      return std::string_view(text_).substr(begin, end - begin);
    }
    const std::size_t unfinished = text_.size() - begin_;
    if (unfinished > files::longest_line) throw FileError("a line is too long");
    ended_ = !more();
    seen = begin_ + unfinished;
    if (ended_ && begin_ != text_.size()) throw FileError("the last line has no line feed");
  }
  return std::nullopt;
}

}  // namespace fathom::golden
