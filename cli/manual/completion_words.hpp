// SPDX-License-Identifier: GPL-3.0-or-later
// What the scripts of all shells are made of.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/help_page.hpp"

namespace fathom::cli {

inline constexpr std::string_view made_by = "# Commands, options and values of fathom; made by `fathom completion`.";
inline constexpr const char* shells[] = {"bash", "zsh", "fish"};

/// What may stand behind an option.
enum class ValueKind { none, words, list, file, folder, other };

inline ValueKind value_kind(const OptionHelp& option) {
  if (!option.choices.empty()) return option.value == "FLAGS" ? ValueKind::list : ValueKind::words;
  if (option.value.empty() || option.value.front() == '[') return ValueKind::none;
  if (option.value == "DIR") return ValueKind::folder;
  return option.value == "FILE" || option.value == "CASES" || option.value == "Q" ? ValueKind::file : ValueKind::other;
}

inline bool is_task(const CommandHelp& command) { return command.name.find(' ') != command.name.npos; }

/// The words, none of which is an option, that may stand behind the command; empty if only files do.
inline std::vector<std::string> words_behind(const HelpPage& page, std::span<const HelpPage> pages) {
  std::vector<std::string> words;
  if (page.command.name == "completion") return {std::begin(shells), std::end(shells)};
  const HelpPage& source = page.command.name == "help" || page.command.name == "man" ? pages.front() : page;
  for (const CommandHelp& command : source.commands) words.emplace_back(last_word(command));
  return words;
}

/// The beginning of a meaning, up to the first stop, in one line.
inline std::string short_meaning(std::string_view meaning) {
  constexpr std::size_t longest = 70;
  std::string text(meaning.substr(0, std::min(meaning.find(". "), meaning.find("; "))));
  std::ranges::replace(text, '\n', ' ');
  if (text.size() <= longest) return text;
  return text.substr(0, text.rfind(' ', longest)) + " ...";
}

/// `text` with a backslash before each of the characters.
inline std::string escaped(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != characters.npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace fathom::cli
