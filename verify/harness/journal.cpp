// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/harness/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <set>
#include <string_view>
#include <utility>

#include "fathom/files.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "reference/text/json_value.hpp"

namespace fathom::harness {
namespace {

constexpr mode_t as_umask_allows = 0666;

bool exists_and_holds_something(const std::string& path) {
  struct stat about = {};
  return ::stat(path.c_str(), &about) == 0 && (!S_ISREG(about.st_mode) || about.st_size > 0);
}

/// Reads the lines of a journal, and returns the number of its bytes to keep.
std::size_t kept_bytes(const std::string& text, const std::string& path, const std::string& header,
                       const std::function<void(Outcome)>& known,
                       const std::function<void(Unattributed)>& unattributed) {
  std::size_t kept = 0, number = 0;
  for (std::size_t newline = text.find('\n'); newline != std::string::npos; newline = text.find('\n', kept)) {
    const std::string_view line = std::string_view(text).substr(kept, newline - kept);
    ++number;
    if (number == 1 && !same_run(line, header))
      throw InputError(path, 1,
                       "this report is of another subject, version, setting, tolerance or policy: expected " + header +
                           ", found " + std::string(line));
    if (number > 1 && begins_line(line, "summary")) return kept;
    if (number > 1) {
      if (std::optional<Outcome> outcome = read_outcome(line)) known(*std::move(outcome));
      else if (std::optional<Unattributed> thing = read_unattributed(line)) unattributed(*std::move(thing));
      else throw InputError(path, number, "expected a line of schema fathom/verdict/1, found " + kernels::shown(line));
    }
    kept = newline + 1;
  }
  return kept;
}

using text::JsonValue;

constexpr int digits_of_binary32 = 24, digits_of_binary64 = 53;

/// Returns the type of a line of a report; empty for other lines.
std::string type_of(const JsonValue& line) {
  const JsonValue *const schema = line.find("schema"), *const type = line.find("type");
  const bool is_ours = schema && schema->is_string() && schema->string() == "fathom/verdict/1";
  return is_ours && type && type->is_string() ? type->string() : "";
}

JsonValue value_on(std::string_view line) {
  text::JsonRead read = text::read_json(line);
  return read.whole ? std::move(read.value) : JsonValue();
}

void flatten(const JsonValue& json, const std::string& path, std::map<std::string, std::string>& fields) {
  if (!json.is_object()) fields[path] = json.is_string() ? json.string() : json.written().text();
  for (const auto& [name, value] : json.fields())
    flatten(*value, path.empty() ? std::string(name) : path + '.' + std::string(name), fields);
}

/// Returns whether the precision of points is binary32.
bool header_says_binary32(const std::map<std::string, std::string>& header) {
  for (const char* field : {"subject.precision", "subject.precision.points"})
    if (const auto found = header.find(field); found != header.end() && found->second == name(Precision::binary32))
      return true;
  return false;
}

void take_header(const JsonValue& header, ReportFile& report) {
  flatten(header, "", report.header);
  for (const char* name : {"schema", "type", "command", "subject.type", "subject.protocol"}) report.header.erase(name);
  const bool is_binary32 = header_says_binary32(report.header);
  report.unit_roundoff = std::ldexp(1, -(is_binary32 ? digits_of_binary32 : digits_of_binary64));
}

/// Reads one line after the header. Returns false if it is not a line of a report.
bool take_line(std::string_view text, ReportFile& report) {
  report.whole = false;
  if (std::optional<Outcome> outcome = read_outcome(text)) report.outcomes.push_back(*std::move(outcome));
  else if (read_unattributed(text)) ++report.unattributed;
  else if (type_of(value_on(text)) == "summary") report.whole = true;
  else return false;
  return true;
}

/// Removes all lines of an id but the last.
void drop_repeated(ReportFile& report) {
  std::set<std::pair<std::string, std::string>> seen;
  std::vector<Outcome> kept;
  for (auto outcome = report.outcomes.rbegin(); outcome != report.outcomes.rend(); ++outcome)
    if (seen.emplace(outcome->id, outcome->variant).second) kept.push_back(std::move(*outcome));
  report.repeated = report.outcomes.size() - kept.size();
  report.outcomes.assign(std::move_iterator(kept.rbegin()), std::move_iterator(kept.rend()));
}

}  // namespace

Journal::Journal(std::string path)
    : path_(std::move(path)), file_(::open(path_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, as_umask_allows)) {
  if (file_ < 0) throw InputError(path_, 0, std::string("cannot be written: ") + std::strerror(errno));
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(file_);
  throw InputError(path_, 0, "another run is writing it");
}

Journal::Journal(Journal&& other) noexcept : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

Journal::~Journal() {
  if (file_ >= 0) ::close(file_);
}

Journal Journal::create(const std::string& path, const std::string& header, bool overwrite) {
  const bool is_there = exists_and_holds_something(path);
  if (is_there && !overwrite)
    throw InputError(
        path, 0,
        "it exists; --resume goes on with a report that is there, --overwrite replaces it, or name another file");
  if (is_there && !begins_line(files::read_file(path), "header"))
    throw InputError(path, 1, "expected a report, which alone --overwrite replaces, found another file");
  Journal journal(path);
  if (is_there && ::ftruncate(journal.file_, 0) != 0)
    throw InputError(path, 0, std::string("cannot be replaced: ") + std::strerror(errno));
  journal.add(header);
  return journal;
}

Journal Journal::resume(const std::string& path, const std::string& header, const std::function<void(Outcome)>& known,
                        const std::function<void(Unattributed)>& unattributed) {
  Journal journal(path);
  const std::string text = files::read_file(path);
  const std::size_t kept = kept_bytes(text, path, header, known, unattributed);
  if (kept < text.size() && ::ftruncate(journal.file_, static_cast<off_t>(kept)) != 0)
    throw InputError(path, 0, std::string("its last line cannot be cut off: ") + std::strerror(errno));
  if (kept == 0) journal.add(header);
  return journal;
}

void Journal::add(const std::string& line) {
  if (const int code = files::write_all(file_, line + '\n'); code != 0)
    throw JournalError(path_ + ": cannot be written: " + std::strerror(code));
}

std::string ReportFile::title() const {
  const auto field = [this](const char* name) {
    const auto found = header.find(name);
    return found == header.end() ? std::string() : found->second;
  };
  const std::string version = field("subject.version");
  return fmt::format("{}{}{}, fathom {}", field("subject.name"), version.empty() ? "" : " ", version, field("fathom"));
}

ReportFile read_report(const std::string& path) {
  ReportFile report;
  report.path = path;
  const std::string text = files::read_file(path);
  std::size_t number = 0;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    ++number;
    if (number == 1) {
      const JsonValue header = value_on(line);
      if (type_of(header) != "header")
        throw InputError(path, 1,
                         "expected the header of a report, schema fathom/verdict/1, found " + kernels::shown(line));
      take_header(header, report);
    } else if (!take_line(line, report) && end < text.size()) {
      throw InputError(path, number, "expected a line of schema fathom/verdict/1, found " + kernels::shown(line));
    }
  }
  if (number == 0) throw InputError(path, 0, "it is empty: expected a report, schema fathom/verdict/1");
  drop_repeated(report);
  return report;
}

}  // namespace fathom::harness
