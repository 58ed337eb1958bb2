// SPDX-License-Identifier: GPL-3.0-or-later
// The table of commands, with their words; and pages of help: what --help, `fathom help`, the man
// pages and the completion of shells are made of.
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

/// A line for a shell, and what it is good for.
struct Example {
  std::string_view line, meaning;
};

struct ExitMeaning {
  int code;
  std::string_view meaning;
};

/// What is written by hand about a command.
struct CommandHelp {
  std::string_view name;  ///< the words behind "fathom": "depth", "golden verify"; empty for fathom itself
  std::string_view summary, synopsis;
  std::span<const Example> examples;
  std::span<const ExitMeaning> exits;
  std::span<const std::string_view> notes = {};  ///< paragraphs
};

/// An option.
struct OptionHelp {
  std::vector<std::string> names;         ///< "-h", "--help"
  std::string value;                      ///< "NAME"; in brackets if it may be missing; empty if there is none
  std::string meaning;                    ///< white space is no more than that
  std::vector<std::string> choices = {};  ///< the values, if they are few
};

/// A page: what is written by hand, with the options of the table.
struct HelpPage {
  CommandHelp command;
  std::vector<OptionHelp> options;
  std::vector<CommandHelp> commands = {};  ///< those one level down
  bool takes_input = false;                ///< files may stand where else the name of one of these does
};

/// "fathom depth".
std::string full_name(const CommandHelp& command);

/// The last word of the name: "depth", "verify".
inline std::string_view last_word(const CommandHelp& command) {
  return command.name.substr(command.name.rfind(' ') + 1);
}

/// The page of a command, or of fathom itself, whose name is "".
HelpPage page_of(std::string_view command, std::span<const Option> table);

/// Returns the page in lines of at most `columns` characters, examples first, without the last
/// newline.
std::string help_text(const HelpPage& page, std::size_t columns);

/// The page of fathom itself, and the commands in the order of its help, each with its tasks behind
/// it.
extern const CommandHelp general_help;
extern const std::span<const CommandHelp> command_table;

/// The name of the command that this one is a task of: "golden" of "golden verify"; "" of others.
inline std::string_view parent(const CommandHelp& command) {
  const std::size_t space = command.name.rfind(' ');
  return space == command.name.npos ? "" : command.name.substr(0, space);
}

/// Commands that take their words themselves, and those of their tasks.
constexpr bool parses_itself(std::string_view command) {
  constexpr std::string_view names[] = {"check", "golden", "help", "man", "completion"};
  return std::ranges::find(names, command) != std::end(names);
}

/// The names of the commands that are no tasks.
inline std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const CommandHelp& command : command_table)
    if (parent(command).empty()) names.emplace_back(command.name);
  return names;
}

}  // namespace fathom::cli
