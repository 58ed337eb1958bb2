// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/files/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace fathom::files {
namespace {

[[noreturn]] void fail(int code) { throw std::system_error(code, std::generic_category()); }

// The file behind symbolic links, which need not exist yet, so that a link stays one.
std::string resolved(const std::string& path) {
  constexpr int most_links = 40;  // as Linux follows
  std::error_code none;
  std::filesystem::path target = path;
  for (int links = 0; std::filesystem::is_symlink(target, none); ++links) {
    if (links == most_links) fail(ELOOP);
    target = target.parent_path() / std::filesystem::read_symlink(target, none);
  }
  return target.string();
}

// A hidden file in the folder, of a name that none has: one may be left from a process that was killed.
int open_hidden(const std::filesystem::path& folder, std::string& name) {
  for (unsigned number = 0;; ++number) {
    const std::string id = std::to_string(::getpid()) + "-" + std::to_string(number);
    name = (folder / (".fathom-" + id + ".tmp")).string();  // short, whatever the name to come
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

}  // namespace

WholeFile::WholeFile(const std::string& path) : path_(resolved(path)) {
  struct stat found {};
  const bool exists = ::stat(path_.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) fail(EISDIR);
  descriptor_ = exists && !S_ISREG(found.st_mode) ? ::open(path_.c_str(), O_WRONLY | O_CLOEXEC)
                                                  : open_hidden(std::filesystem::path(path_).parent_path(), hidden_);
  if (descriptor_ < 0) fail(errno);
}

WholeFile::~WholeFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!hidden_.empty()) ::unlink(hidden_.c_str());
}

void WholeFile::write(std::string_view bytes) {
  if (const int code = write_all(descriptor_, bytes); code != 0) fail(code);
}

void WholeFile::put_in_place() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (hidden_.empty()) return;
  if (std::rename(hidden_.c_str(), path_.c_str()) != 0) fail(errno);
  hidden_.clear();
}

int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace fathom::files
