// SPDX-License-Identifier: GPL-3.0-or-later
// The part of completion.hpp for fish.
#include "cli/manual/manual.hpp"

namespace fathom::cli {
namespace {

using Lines = std::vector<std::string>;

std::string fish_quoted(std::string_view text) { return "'" + escaped(text, "'\\") + "'"; }

/// What must have been typed for the page to be meant.
std::string condition(const HelpPage& page) {
  if (page.command.name.empty()) return "__fish_use_subcommand";
  std::string result = "__fish_seen_subcommand_from " + std::string(page.command.name.substr(0, page.command.name.find(' ')));
  if (is_task(page.command)) result += fmt::format("; and __fish_seen_subcommand_from {}", last_word(page.command));
  return result;
}

void add_options(Lines& lines, const HelpPage& page) {
  for (const OptionHelp& option : page.options) {
    std::string line = "complete -c fathom -n " + fish_quoted(condition(page));
    for (const std::string& name : option.names) line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    switch (value_kind(option)) {
      case ValueKind::none: break;
      case ValueKind::words: line += fmt::format(" -x -a '{}'", fmt::join(option.choices, " ")); break;
      case ValueKind::list: line += fmt::format(" -x -a '(__fish_append , {})'", fmt::join(option.choices, " ")); break;
      case ValueKind::file: line += " -r -F"; break;
      case ValueKind::folder: line += " -x -a '(__fish_complete_directories)'"; break;
      case ValueKind::other: line += " -x"; break;
    }
    lines.push_back(line + " -d " + fish_quoted(short_meaning(option.meaning)));
  }
}

/// The words behind a command, offered once: with their summaries if these are commands themselves.
void add_words(Lines& lines, const HelpPage& page, std::span<const HelpPage> pages) {
  const Lines behind = words_behind(page, pages);
  if (behind.empty()) return;
  std::string when = condition(page);
  if (!page.command.name.empty()) when += fmt::format("; and not __fish_seen_subcommand_from {}", fmt::join(behind, " "));
  // Behind `help`, which is a command too, the others have not been typed yet.
  if (page.command.name == "help" || page.command.name == "man") when = condition(page);
  if (page.commands.empty()) lines.push_back(fmt::format("complete -c fathom -f -n {} -a '{}'", fish_quoted(when), fmt::join(behind, " ")));
  for (const CommandHelp& command : page.commands)
    lines.push_back(fmt::format("complete -c fathom{} -n {} -a {} -d {}", page.takes_input ? "" : " -f", fish_quoted(when),
                                last_word(command), fish_quoted(command.summary)));
}

}  // namespace

std::string fish_completion(std::span<const HelpPage> pages) {
  Lines lines = {std::string(made_by)};
  for (const HelpPage& page : pages) {
    add_words(lines, page, pages);
    add_options(lines, page);
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace fathom::cli
