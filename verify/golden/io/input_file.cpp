// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/golden/io/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "verify/golden/io/file_error.hpp"

namespace fathom::golden {
namespace {

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

}  // namespace fathom::golden
