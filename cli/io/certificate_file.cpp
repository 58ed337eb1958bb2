// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/certificate_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "cli/io/output.hpp"
#include "fathom/files.hpp"
#include "verify/digest/sha256.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t longest_name = 255;  // of a file, in bytes
constexpr std::size_t kept_of_long = 180;  // of a name that would be longer

[[noreturn]] void refuse(const std::string& path, const std::string& why, const std::string& what = "certificate") {
  throw InputError(path, 0, "cannot write a " + what + ": " + why);
}

bool is_safe(unsigned char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
}

// The file behind symbolic links, which need not exist yet, so that a link stays one.
std::string resolved(const std::string& path, const std::string& what) {
  constexpr int most_links = 40;  // as Linux follows
  std::error_code none;
  std::filesystem::path target = path;
  for (int links = 0; std::filesystem::is_symlink(target, none); ++links) {
    if (links == most_links) refuse(path, std::strerror(ELOOP), what);
    target = target.parent_path() / std::filesystem::read_symlink(target, none);
  }
  return target.string();
}

// A hidden file in the folder, of a name that none has: one may be left from a process that was killed.
int open_temporary(const std::filesystem::path& folder, std::string& name) {
  for (unsigned number = 0;; ++number) {
    name = (folder / fmt::format(".fathom-{}-{}.tmp", ::getpid(), number)).string();  // short, whatever the name to come
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
}

}  // namespace

CertificateFile::CertificateFile(std::string path, std::string what) : what_(std::move(what)), path_(resolved(path, what_)) {
  struct stat found {};
  const bool exists = ::stat(path_.c_str(), &found) == 0;
  if (exists && S_ISDIR(found.st_mode)) refuse(path, "is a directory", what_);
  if (exists && !S_ISREG(found.st_mode)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    descriptor_ = open_temporary(std::filesystem::path(path_).parent_path(), temporary_);
  }
  if (descriptor_ < 0) refuse(path, std::strerror(errno), what_);
}

CertificateFile::~CertificateFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void CertificateFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
  if (!temporary_.empty() && std::rename(temporary_.c_str(), path_.c_str()) != 0) fail();
}

void CertificateFile::fail() {
  const std::string why = std::strerror(errno);
  if (descriptor_ < 0 && !temporary_.empty()) ::unlink(temporary_.c_str());  // else the destructor sees to it
  throw OutputError(path_ + ": cannot write the " + what_ + ": " + why);
}

CertificateFolder::CertificateFolder(std::string path, std::string what, std::string ending)
    : path_(std::move(path)), what_(std::move(what)), ending_(std::move(ending)) {
  std::error_code fault;
  std::filesystem::create_directory(path_, fault);
  if (!std::filesystem::is_directory(path_)) refuse(path_, fault ? fault.message() : "a stream needs a directory, and this is none", what_);
  if (::access(path_.c_str(), W_OK | X_OK) != 0) refuse(path_, std::strerror(errno), what_);
}

std::string CertificateFolder::file(const std::string& id) {
  const std::string name = certificate_file_name(id, ending_);
  if (!names_.insert(name).second) refuse(path_ + "/" + name, "it belongs to an earlier case with the same id", what_);
  return path_ + "/" + name;
}

std::string certificate_file_name(const std::string& id, const std::string& ending) {
  std::string name;
  for (const char c : id) {
    const auto byte = static_cast<unsigned char>(c);
    const bool hidden = name.empty() && c == '.';
    if (is_safe(byte) && !hidden) name += c;
    else name += fmt::format("%{:02X}", byte);
  }
  if (name.empty()) name = "%";
  if (name.size() + ending.size() > longest_name) name = name.substr(0, kept_of_long) + '~' + digest::digest_of(id).sha256;
  return name + ending;
}

}  // namespace fathom::cli
