// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/help_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/args/help.hpp"
#include "cli/args/values.hpp"
#include "cli/io/terminal.hpp"
#include "verify/check/command_line.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t margin = 2;
constexpr std::size_t wide = 100;           // columns from which on meanings stand beside what they explain
constexpr std::size_t beside_example = 43;  // where they begin then
constexpr std::size_t beside_option = 28, below_option = 6;
constexpr std::size_t enough_for_options = 60;

using Lines = std::vector<std::string>;

/// A line for a shell, broken behind backslashes where no quotation is open, so that it still runs.
std::string broken_line(std::string_view line, std::size_t width) {
  std::string result;
  std::size_t column = 0, last_space = line.npos, begin = 0;
  char quotation = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quotation != 0) quotation = c == quotation ? '\0' : quotation;
    else if (c == '\'' || c == '"') quotation = c;
    else if (c == ' ') last_space = i;
    const std::size_t behind = i + 1 < line.size() ? 2 : 0;  // columns for " \"
    if (++column + behind > width && last_space != line.npos && last_space > begin) {
      result += fmt::format("{} \\\n{:{}}", line.substr(begin, last_space - begin), "", 2 * margin + 2);
      begin = last_space + 1;
      column = i + 1 - begin + margin + 2;
    }
  }
  return result + std::string(line.substr(begin));
}

/// The text in one line.
std::string joined(std::string_view text) {
  std::string result(text);
  std::ranges::replace(result, '\n', ' ');
  return result;
}

/// Adds what is explained and, beside it where there is room, else below it, the meaning from
/// `column` on.
void add_explained(Lines& lines, std::string_view title, std::string_view meaning, std::size_t column,
                   std::size_t columns) {
  std::string text = fmt::format("{:{}}{}", "", margin, title);
  if (text.size() + margin > column || text.find('\n') != text.npos) {
    lines.push_back(text);
    text.clear();
  }
  if (!meaning.empty())
    lines.push_back(folded(fmt::format("{:<{}}{}", text, column, joined(meaning)), columns, column));
  else if (!text.empty()) lines.push_back(text);
}

void add_examples(Lines& lines, std::span<const Example> examples, std::size_t columns) {
  lines.emplace_back("Examples");
  for (const Example& example : examples)
    add_explained(lines, broken_line(example.line, columns - margin), example.meaning,
                  columns >= wide ? beside_example : below_option, columns);
}

void add_options(Lines& lines, const HelpPage& page, std::size_t columns) {
  const std::size_t column = columns >= enough_for_options ? beside_option : below_option;
  lines.emplace_back();
  lines.emplace_back("Options");
  for (const OptionHelp& option : page.options)
    add_explained(lines, option_title(option), option.meaning, column, columns);
  if (page.commands.empty()) return;
  std::size_t longest = 0;
  for (const CommandHelp& command : page.commands) longest = std::max(longest, last_word(command).size());
  lines.emplace_back();
  lines.emplace_back("Commands");
  for (const CommandHelp& command : page.commands)
    add_explained(lines, last_word(command), command.summary, margin + longest + margin, columns);
}

OptionHelp help_of(const Option& option) {
  OptionHelp help{words_of(option.names), option.value, option.meaning, option.values.words};
  for (std::string& name : help.names) name = name.substr(0, name.find('{'));
  if (option.required) help.meaning += "; required";
  return help;
}

std::string exits_text(std::span<const ExitMeaning> exits) {
  Lines parts;
  for (const ExitMeaning& exit : exits) parts.push_back(fmt::format("{} {}", exit.code, exit.meaning));
  return fmt::format("Exit codes: {}.", fmt::join(parts, "; "));
}

}  // namespace

std::string full_name(const CommandHelp& command) {
  return command.name.empty() ? "fathom" : "fathom " + std::string(command.name);
}

std::string option_title(const OptionHelp& option) {
  return fmt::format("{}{}{}", fmt::join(option.names, ", "),
                     option.value.empty() || option.value.front() == '[' ? "" : " ", option.value);
}

HelpPage page_of(std::string_view command, std::span<const Option> table) {
  const auto found = std::ranges::find(command_table, command, &CommandHelp::name);
  HelpPage page{found == std::end(command_table) ? general_help : *found, {}};
  if (command == "check") {  // the checker has a parser of its own, and says what it takes
    for (const auto& [name, value, meaning] : fathom_check::option_texts) {
      page.options.push_back({{std::string(name)}, std::string(value), std::string(meaning)});
      if (name == "--help") page.options.back().names.insert(page.options.back().names.begin(), "-h");
    }
  } else {
    page.options.push_back({{"-h", "--help"}, "", "print help"});
  }
  if (command.empty())
    page.options.push_back(
        {{"-V", "--version"}, "", "the version, with the commit, that of the golden data, and the licence"});
  for (const Option& option : table)
    if (option.belongs_to(command) && !option.is_input()) page.options.push_back(help_of(option));
  for (const CommandHelp& other : command_table)
    if (parent(other) == command) page.commands.push_back(other);
  page.takes_input = command == "certify";
  return page;
}

std::string help_text(const HelpPage& page, std::size_t columns) {
  Lines lines;
  add_examples(lines, page.command.examples, columns);
  lines.emplace_back();
  lines.push_back(folded(page.command.summary, columns));
  lines.push_back(folded(fmt::format("Usage: {}", page.command.synopsis), columns, below_option));
  add_options(lines, page, columns);
  lines.emplace_back();
  for (const std::string_view note : page.command.notes) lines.push_back(folded(note, columns));
  lines.push_back(folded(exits_text(page.command.exits), columns));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace fathom::cli
