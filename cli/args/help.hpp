// SPDX-License-Identifier: GPL-3.0-or-later
// The table of commands with their texts; and pages of help, from which --help, `fathom help`, the
// man pages and the completion of shells are made.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/arguments.hpp"

namespace fathom::cli {

/// A shell command, and its purpose.
struct Example {
  std::string_view line, meaning;
};

struct ExitMeaning {
  int code;
  std::string_view meaning;
};

/// The texts on a command that are written by hand.
struct CommandHelp {
  std::string_view name;  ///< the words after "fathom": "depth", "golden verify"; empty for fathom itself
  std::string_view summary, synopsis;
  std::span<const Example> examples;
  std::span<const ExitMeaning> exits;
  std::span<const std::string_view> notes = {};  ///< paragraphs
};

/// An option.
struct OptionHelp {
  std::vector<std::string> names;         ///< "-h", "--help"
  std::string value;                      ///< "NAME"; in brackets if it may be missing; empty if there is none
  std::string meaning;                    ///< help breaks it anew: line ends and spaces are alike
  std::vector<std::string> choices = {};  ///< the values, if they are few
};

/// A page: the texts on a command, with its options from the table.
struct HelpPage {
  CommandHelp command;
  std::vector<OptionHelp> options;
  std::vector<CommandHelp> commands = {};  ///< the commands or tasks below it
  bool takes_input = false;                ///< files may stand in the place of a command's name
};

/// Returns "fathom depth".
std::string full_name(const CommandHelp& command);

/// Returns the last word of the name: "depth", "verify".
inline std::string_view last_word(const CommandHelp& command) {
  return command.name.substr(command.name.rfind(' ') + 1);
}

/// Returns the page of a command, or of fathom itself, whose name is "".
HelpPage page_of(std::string_view command, std::span<const Option> table);

/// Returns the page in lines of at most `columns` characters, examples first, without the last
/// newline.
std::string help_text(const HelpPage& page, std::size_t columns);

/// The texts on fathom itself, and on the commands in the order of its help, each with its tasks
/// after it.
extern const CommandHelp general_help;
extern const std::span<const CommandHelp> command_table;

/// Returns the command of a task, "golden" for "golden verify"; "" for others.
inline std::string_view parent(const CommandHelp& command) {
  const std::size_t space = command.name.rfind(' ');
  return space == command.name.npos ? "" : command.name.substr(0, space);
}

/// Returns whether the command, or the command of a task, parses its words itself.
constexpr bool parses_itself(std::string_view command) {
  constexpr std::string_view names[] = {"check", "golden", "help", "man", "completion"};
  return std::ranges::find(names, command) != std::end(names);
}

/// Returns the names of the commands that are no tasks.
inline std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const CommandHelp& command : command_table)
    if (parent(command).empty()) names.emplace_back(command.name);
  return names;
}

}  // namespace fathom::cli
