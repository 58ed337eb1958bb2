// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/io/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <system_error>

namespace fathom::cli {
namespace {

constexpr std::size_t usual_columns = 80, least_columns = 20, most_of_help = 120;

/// The width of a terminal that says it.
std::optional<std::size_t> said_columns(int descriptor) {
  winsize size = {};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return std::nullopt;
  return size.ws_col;
}

/// COLUMNS, which users and tests set.
std::optional<std::size_t> wanted_columns() {
  const char* const text = std::getenv("COLUMNS");
  if (text == nullptr) return std::nullopt;
  const std::string_view digits = text;
  std::size_t columns = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), columns);
  return error == std::errc() && end == digits.data() + digits.size() && columns > 0 ? std::optional(columns)
                                                                                     : std::nullopt;
}

/// One line of folded().
void add_folded(std::string& result, std::string_view line, std::size_t width, std::size_t indent) {
  const std::string margin(std::min(indent, width / 2), ' ');
  std::size_t unbroken = margin.size();  // characters in front that stay as they are
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

}  // namespace

// mpirun gives its processes terminals of its own, which nobody sees.
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

}  // namespace fathom::cli
