// SPDX-License-Identifier: GPL-3.0-or-later
// Files by the calls of POSIX, and the sentence of an InputError.
#include "reference/files/file_io.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "fathom/files.hpp"
#include "kernels/messages.hpp"

namespace fathom::files {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& found) {
  throw InputError(path, 0, "expected a readable file, found " + found);
}

[[noreturn]] void refuse_with_errno(const std::string& path) {
  const int code = errno;
  if (code == ENOENT || code == ENOTDIR) refuse(path, "none of this name");
  if (code == EISDIR) refuse(path, "a directory");
  refuse(path, "'" + std::string(std::strerror(code)) + "'");
}

struct Descriptor {
  int value;
  explicit Descriptor(int v) : value(v) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
};

// A null byte would silently end the name.
void require_plain_name(const std::string& path) {
  if (path.find('\0') != std::string::npos) refuse(kernels::shown(path), "a null byte in its name");
}

// What is left of the limits on a line while it is read.
class GrowingLine {
 public:
  explicit GrowingLine(std::string& text) : text_(&text) { text.clear(); }

  void add(std::string_view piece) {
    size_ += piece.size();
    if (size_ > longest_line) give_up(LineRead::too_long);
    if (read_ != LineRead::whole) return;
    try {
      text_->append(piece);
    } catch (const std::bad_alloc&) {
      give_up(LineRead::no_memory);
    }
  }
  [[nodiscard]] bool endless() const { return size_ > 16 * longest_line; }
  [[nodiscard]] LineRead read() const { return read_; }

 private:
  void give_up(LineRead why) {
    read_ = why;
    std::string().swap(*text_);
  }

  std::string* text_;
  std::size_t size_ = 0;
  LineRead read_ = LineRead::whole;
};

// The file behind symbolic links, which need not exist yet, so that a link stays one.
std::string resolved(const std::string& path) {
  constexpr int most_links = 40;  // as Linux follows
  std::error_code none;
  std::filesystem::path target = path;
  for (int links = 0; std::filesystem::is_symlink(target, none); ++links) {
    if (links == most_links) throw FileError("write", path, ELOOP);
    target = target.parent_path() / std::filesystem::read_symlink(target, none);
  }
  return target.string();
}

// A hidden file in the folder, of a name that none has: one may be left from a process that was
// killed.
int open_hidden(const std::filesystem::path& folder, std::string& name) {
  for (unsigned number = 0;; ++number) {
    const std::string id = std::to_string(::getpid()) + "-" + std::to_string(number);
    name = (folder / (".fathom-" + id + ".tmp")).string();  // short, whatever the name to come
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

// A hidden file that no two processes write at once: the lock ends with the process, however that
// ends. Another one may have renamed or removed the file before the lock was free.
int open_locked(const std::string& hidden, const std::string& path) {
  for (;;) {
    const int descriptor = ::open(hidden.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor < 0) throw FileError("write", path, errno);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor);
      throw FileError("cannot write " + path + ": another process is writing it");
    }
    struct stat ours = {}, named = {};
    const bool same =
        ::fstat(descriptor, &ours) == 0 && ::stat(hidden.c_str(), &named) == 0 && ours.st_ino == named.st_ino;
    if (same && ::ftruncate(descriptor, 0) == 0) return descriptor;
    const int number = errno;
    ::close(descriptor);
    if (same) throw FileError("write", path, number);
  }
}

}  // namespace

LineRead read_line(std::istream& input, std::string& line) {
  char block[1 << 14];
  GrowingLine growing(line);
  for (bool any = false;; any = true) {
    input.getline(block, sizeof block);
    const auto got = static_cast<std::size_t>(input.gcount());
    const bool full = input.fail() && got == sizeof block - 1;  // and the line goes on
    if (input.bad() || (got == 0 && !any)) return LineRead::none;
    growing.add({block, full || input.eof() ? got : got - 1});  // without the line feed
    if (!full) return growing.read();
    input.clear(growing.endless() ? std::ios::badbit : std::ios::goodbit);
    if (growing.endless()) return growing.read();
  }
}

std::string read_file(const std::string& path, std::size_t most_of_a_pipe) {
  require_plain_name(path);
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (file.value < 0 || ::fstat(file.value, &status) != 0) refuse_with_errno(path);
  if (S_ISDIR(status.st_mode)) refuse(path, "a directory");
  std::string bytes;
  if (S_ISREG(status.st_mode)) bytes.reserve(static_cast<std::size_t>(status.st_size));
  std::vector<char> block(std::size_t{1} << 18);
  while (true) {
    const ssize_t got = ::read(file.value, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_with_errno(path);
    if (got == 0) return bytes;
    bytes.append(block.data(), static_cast<std::size_t>(got));
    if (!S_ISREG(status.st_mode) && bytes.size() > most_of_a_pipe)
      refuse(path, "a pipe or device of more than " + std::to_string(most_of_a_pipe) + " bytes");
  }
}

// Does not open it: a writer to a named pipe would see its reader leave.
void require_readable(const std::string& path) {
  require_plain_name(path);
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) refuse_with_errno(path);
  if (S_ISDIR(status.st_mode)) refuse(path, "a directory");
  if (::faccessat(AT_FDCWD, path.c_str(), R_OK, AT_EACCESS) != 0) refuse_with_errno(path);
}

bool is_folder(const std::string& path) {
  struct stat status {};
  return path.find('\0') == std::string::npos && ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

std::string extension(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  const std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return "";
  std::string result(name.substr(dot + 1));
  std::ranges::transform(result, result.begin(), kernels::lower);
  return result;
}

FileError::FileError(const std::string& action, const std::filesystem::path& path, int number)
    : std::runtime_error("cannot " + action + " " + path.string() + ": " + std::generic_category().message(number)),
      code(number, std::generic_category()) {}

WholeFile::WholeFile(const std::string& path) : path_(resolved(path)) {
  struct stat found {};
  const bool exists = ::stat(path_.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) fail(EISDIR);
  descriptor_ = exists && !S_ISREG(found.st_mode) ? ::open(path_.c_str(), O_WRONLY | O_CLOEXEC)
                                                  : open_hidden(std::filesystem::path(path_).parent_path(), hidden_);
  if (descriptor_ < 0) fail(errno);
}

WholeFile::WholeFile(const std::filesystem::path& path, const std::string& hidden)
    : path_(path.string()), hidden_((path.parent_path() / hidden).string()), descriptor_(open_locked(hidden_, path_)) {}

WholeFile::~WholeFile() {
  if (!hidden_.empty()) ::unlink(hidden_.c_str());  // while the lock is held
  if (descriptor_ >= 0) ::close(descriptor_);
}

void WholeFile::write(std::string_view bytes) {
  if (const int number = write_all(descriptor_, bytes); number != 0) fail(number);
}

void WholeFile::sync() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(errno);
}

void WholeFile::put_in_place() {
  // closing a copy tells what the system has kept back so far, and leaves the lock
  if (const int copy = ::dup(descriptor_); copy < 0 || ::close(copy) != 0) fail(errno);
  if (!hidden_.empty() && std::rename(hidden_.c_str(), path_.c_str()) != 0) fail(errno);
  hidden_.clear();
  ::close(std::exchange(descriptor_, -1));
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

namespace fathom {
namespace {

std::string sentence(const std::string& file, std::size_t line, const std::string& message) {
  return file + ":" + (line ? std::to_string(line) + ":" : "") + " " + message;
}

}  // namespace

InputError::InputError(std::string file, std::size_t line, const std::string& message)
    : std::runtime_error(sentence(file, line, message)), file_(std::move(file)), line_(line) {}

}  // namespace fathom
