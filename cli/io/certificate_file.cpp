// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/certificate_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/io/output.hpp"
#include "fathom/files.hpp"
#include "verify/check/reader.hpp"
#include "verify/digest/sha256.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t longest_name = 255;  // of a file, in bytes
constexpr std::size_t kept_of_long = 180;  // bytes kept of a longer name

[[noreturn]] void refuse(const std::string& path, const std::string& why, const std::string& what = "certificate") {
  throw InputError(path, 0, "cannot write a " + what + ": " + why);
}

bool is_safe(unsigned char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
}

/// Returns the id with `ending`. Whatever is not a letter, a digit or one of . _ - becomes %XX, and
/// so does a leading dot. Where the name would be too long for a file, it is cut, and '~' and the
/// SHA-256 of the id follow. Different ids make different names.
std::string certificate_file_name(const std::string& id, const std::string& ending) {
  std::string name;
  for (const char c : id) {
    const auto byte = static_cast<unsigned char>(c);
    const bool hidden = name.empty() && c == '.';
    if (is_safe(byte) && !hidden) name += c;
    else name += fmt::format("%{:02X}", byte);
  }
  if (name.empty()) name = "%";
  if (name.size() + ending.size() > longest_name)
    name = name.substr(0, kept_of_long) + '~' + digest::digest_of(id).sha256;
  return name + ending;
}

}  // namespace

CertificateFile::CertificateFile(const std::string& path, const std::string& what) try : what_(what), file_(path) {
} catch (const files::FileError& error) {
  refuse(path, error.code == std::errc::is_a_directory ? "is a directory" : error.code.message(), what);
}

void CertificateFile::write(std::string_view text) try {
  file_.write(text);
  file_.put_in_place();
} catch (const files::FileError& error) {
  throw OutputError(file_.path() + ": cannot write the " + what_ + ": " + error.code.message());
}

std::unique_ptr<CertificateFile> wanted_file(const std::string& path, const std::string& what) {
  return path.empty() ? nullptr : std::make_unique<CertificateFile>(path, what);
}

CertificateFolder::CertificateFolder(std::string path, std::string what, std::string ending)
    : path_(std::move(path)), what_(std::move(what)), ending_(std::move(ending)) {
  std::error_code fault;
  std::filesystem::create_directory(path_, fault);
  std::error_code unseen;  // ignored: create_directory has failed for the same reason
  if (!std::filesystem::is_directory(path_, unseen))
    refuse(path_, fault ? fault.message() : "a stream needs a directory, and this is none", what_);
  if (::access(path_.c_str(), W_OK | X_OK) != 0) refuse(path_, std::strerror(errno), what_);
}

std::string CertificateFolder::file(const std::string& id) {
  const std::string name = certificate_file_name(id, ending_);
  if (!names_.insert(name).second) refuse(path_ + "/" + name, "it belongs to an earlier case with the same id", what_);
  return path_ + "/" + name;
}

void require_readable(const std::string& id, std::string_view certificate, const fathom_check::Limits& limits) try {
  fathom_check::require_readable(certificate, limits);
} catch (const fathom_check::Unreadable& refusal) {
  throw OutputError(
      fmt::format("{}: {}. Narrower numbers make it shorter, as --exact-decimals does for short decimals, and so do "
                  "fewer points or pieces; "
                  "without a certificate the depth is printed",
                  id, refusal.what()));
}

}  // namespace fathom::cli
