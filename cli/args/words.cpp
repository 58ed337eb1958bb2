// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/words.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t shortest = 3, longest = 60;  // characters of a word that is worth a look

/// No shell makes anything else of it.
bool is_plain(const std::string& word) {
  constexpr std::string_view others = "-_./,:=+%@";
  const auto plain = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           others.find(c) != std::string_view::npos;
  };
  return !word.empty() && std::ranges::all_of(word, plain);
}

}  // namespace

std::string did_you_mean(const std::string& typed, std::span<const std::string> words) {
  if (words.empty() || typed.size() > longest) return "";
  const auto begins = [&typed](const std::string& word) { return typed.size() >= shortest && word.starts_with(typed); };
  const auto slips = [&typed](const std::string& word) { return kernels::slips(typed, word); };
  const std::string& nearest = *std::ranges::min_element(words, {}, slips);
  const bool only = std::ranges::count_if(words, begins) == 1;
  if (!only && !kernels::is_near(typed, nearest)) return "";
  return "; did you mean '" + (only ? *std::ranges::find_if(words, begins) : nearest) + "'?";
}

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) {
    if (c == '\'') result += "'\\''";
    else result += c;
  }
  return result + '\'';
}

std::string shell_line(std::span<const std::string> words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : " ") + (is_plain(word) ? word : quoted(word));
  return result;
}

std::string command_line(int argc, const char* const* argv) {
  std::vector<std::string> words = {"fathom"};
  words.insert(words.end(), argv + 1, argv + argc);
  return shell_line(words);
}

}  // namespace fathom::cli
