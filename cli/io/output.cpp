// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "fathom/files.hpp"
#include "fathom/monitor.hpp"
#include "verify/check/reader.hpp"
#include "verify/digest/sha256.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t usual_columns = 80, least_columns = 20, most_of_help = 120;

/// Returns the width of the terminal, if it reports one.
std::optional<std::size_t> said_columns(int descriptor) {
  winsize size = {};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

/// Returns the value of COLUMNS, which users and tests set.
std::optional<std::size_t> wanted_columns() {
  const char* const text = std::getenv("COLUMNS");
  if (text == nullptr) return std::nullopt;
  const std::string_view digits = text;
  std::size_t columns = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), columns);
  return error == std::errc() && end == digits.data() + digits.size() && columns > 0 ? std::optional(columns)
                                                                                     : std::nullopt;
}

/// Adds one line of folded().
void add_folded(std::string& result, std::string_view line, std::size_t width, std::size_t indent) {
  const std::string margin(std::min(indent, width / 2), ' ');
  std::size_t unbroken = margin.size();  // the leading characters, among which no line break is made
  for (bool first = true;; first = false) {
    const std::size_t room = first ? width : width - margin.size();
    const std::string_view head = cut(line, room);
    if (head.size() == line.size()) break;
    std::size_t space = line.rfind(' ', head.size());
    if (space == line.npos || space < unbroken) space = line.find(' ', std::max(unbroken, head.size()));
    const std::size_t next = line.find_first_not_of(' ', std::min(space, line.size()));
    if (next == line.npos) break;
    const std::string_view broken = line.substr(0, space);
    result += broken.substr(0, broken.find_last_not_of(' ') + 1);
    result += '\n' + margin;
    line.remove_prefix(next);
    unbroken = 0;
  }
  result += line;
}

constexpr std::size_t sentence_indent = 2;  // spaces before continued lines of a sentence

}  // namespace

// mpirun connects its processes to terminals that nobody sees.
bool is_terminal(int descriptor) {
  return ::isatty(descriptor) == 1 && std::getenv("OMPI_COMM_WORLD_LOCAL_SIZE") == nullptr;
}

std::size_t terminal_columns(int descriptor) { return said_columns(descriptor).value_or(usual_columns); }

std::size_t help_columns(int descriptor) {
  return std::clamp(wanted_columns().value_or(terminal_columns(descriptor)), least_columns, most_of_help);
}

std::size_t seen_columns(int descriptor) {
  return is_terminal(descriptor) ? std::max(terminal_columns(descriptor), least_columns) : unlimited;
}

std::string_view cut(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = 0;
  for (; end < text.size(); ++end) {
    const bool begins_character = (static_cast<unsigned char>(text[end]) & 0xc0) != 0x80;
    if (begins_character && most-- == 0) break;
  }
  return text.substr(0, end);
}

std::string folded(std::string_view text, std::size_t width, std::size_t indent) {
  std::string result;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (begin > 0) result += '\n';
    add_folded(result, text.substr(begin, end - begin), width, indent);
    begin = end + 1;
  }
  return result;
}

std::string fitted(std::string_view text, std::size_t indent) {
  return folded(text, seen_columns(STDOUT_FILENO), indent);
}

void hold_standard_streams() {
  // Opens them in ascending order, because open() returns the lowest free number.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void print(std::string_view text) {
  const std::string line = std::string(text) + '\n';
  if (std::fwrite(line.data(), 1, line.size(), stdout) != line.size() || std::fflush(stdout) != 0)
    throw OutputError(std::string("cannot write to standard output: ") + std::strerror(errno));
}

std::string fault_text(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
  return std::string("internal error: ") + error.what();
}

std::string without_controls(std::string_view text) {
  std::string result;
  bool behind_lead = false;  // in a character of two bytes, U+0080 to U+00BF
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool second = behind_lead && byte >= 0x80 && byte < 0xa0;
    if (second) result.replace(result.size() - 1, 1, "\\xc2");
    if (second || byte < 0x20 || byte == 0x7f) result += fmt::format("\\x{:02x}", byte);
    else result += c;
    behind_lead = byte == 0xc2;
  }
  return result;
}

void talk(std::string_view text) {
  std::string line = "fathom: ";
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    line += without_controls(text.substr(begin, end - begin)) + '\n';
    begin = end + 1;
  }
  line = folded(line, seen_columns(STDERR_FILENO), sentence_indent);
  std::fwrite(line.data(), 1, line.size(), stderr);
}

ExitCode failed(std::string_view sentence, ExitCode code) {
  talk(sentence);
  return code;
}

ExitCode guarded(const std::function<ExitCode()>& run) {
  try {
    return run();
  } catch (const InputError& error) {
    return failed(error.what(), bad_input);
  } catch (const Interrupted&) {
    return failed("interrupted", interrupted);
  } catch (const std::filesystem::filesystem_error& error) {
    return failed(error.path1().string() + ": " + error.code().message(), bad_input);
  } catch (const OutputError& error) {
    return failed(error.what(), internal_error);
  } catch (const std::exception& error) {
    return failed(fault_text(error), internal_error);
  }
}

// ---- files ----

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
