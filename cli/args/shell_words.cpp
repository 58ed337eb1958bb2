// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/shell_words.hpp"

#include <algorithm>
#include <string_view>

namespace fathom::cli {
namespace {

/// No shell makes anything else of it.
bool is_plain(const std::string& word) {
  constexpr std::string_view others = "-_./,:=+%@";
  const auto plain = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || others.find(c) != std::string_view::npos;
  };
  return !word.empty() && std::ranges::all_of(word, plain);
}

}  // namespace

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) {
    if (c == '\'') result += "'\\''";
    else result += c;
  }
  return result + '\'';
}

std::string command_line(int argc, const char* const* argv) {
  std::string result = "fathom";
  for (int i = 1; i < argc; ++i) result += ' ' + (is_plain(argv[i]) ? std::string(argv[i]) : quoted(argv[i]));
  return result;
}

}  // namespace fathom::cli
