// SPDX-License-Identifier: GPL-3.0-or-later
// The part of completion.hpp for zsh.
#include "cli/args/words.hpp"
#include "cli/manual/manual.hpp"

namespace fathom::cli {
namespace {

using Lines = std::vector<std::string>;

/// What _arguments is to offer for a value.
std::string action(const OptionHelp& option) {
  switch (value_kind(option)) {
    case ValueKind::words: return fmt::format(":{}:({})", option.value, fmt::join(option.choices, " "));
    case ValueKind::list: return fmt::format(":{}:_sequence -s , compadd - {}", option.value, fmt::join(option.choices, " "));
    case ValueKind::file: return fmt::format(":{}:_files", option.value);
    case ValueKind::folder: return fmt::format(":{}:_files -/", option.value);
    case ValueKind::other: return fmt::format(":{}: ", escaped(option.value, ":"));
    case ValueKind::none: break;
  }
  return "";
}

/// "    '--method=[how]:NAME:(auto exact)' \" for each name.
void add_options(Lines& lines, const HelpPage& page, const std::string& indent) {
  for (const OptionHelp& option : page.options)
    for (const std::string& name : option.names) {
      const bool takes_value = value_kind(option) != ValueKind::none;
      const std::string spec = fmt::format("{}{}[{}]{}", name, takes_value && name.starts_with("--") ? "=" : "",
                                           escaped(short_meaning(option.meaning), "[]:\\"), action(option));
      lines.push_back(fmt::format("{}{} \\", indent, quoted(spec)));
    }
}

/// One branch: the options, then words or files.
void add_branch(Lines& lines, const HelpPage& page, std::span<const HelpPage> pages, const std::string& indent) {
  const Lines behind = words_behind(page, pages);
  lines.push_back(fmt::format("{}{})", indent, last_word(page.command)));
  lines.push_back(indent + "  _arguments \\");
  add_options(lines, page, indent + "    ");
  lines.push_back(
      fmt::format("{}    {}", indent, behind.empty() ? "'*:input:_files'" : fmt::format("'1:word:({})'", fmt::join(behind, " "))));
  lines.push_back(indent + "  ;;");
}

void add_described(Lines& lines, const std::string& name, std::span<const CommandHelp> commands, const std::string& indent) {
  lines.push_back(fmt::format("{}{}=(", indent, name));
  for (const CommandHelp& command : commands)
    lines.push_back(fmt::format("{}  {}", indent, quoted(fmt::format("{}:{}", last_word(command), escaped(command.summary, ":\\")))));
  lines.push_back(indent + ")");
}

}  // namespace

std::string zsh_completion(std::span<const HelpPage> pages) {
  Lines lines = {"#compdef fathom", std::string(made_by), "_fathom() {", "  local -a commands tasks"};
  add_described(lines, "commands", pages.front().commands, "  ");
  lines.insert(lines.end(), {"  if ((CURRENT == 2)); then", "    _describe command commands", "    _arguments \\"});
  add_options(lines, pages.front(), "      ");
  lines.insert(lines.end(), {"      '*: : '", "    return", "  fi", "  shift words", "  ((CURRENT--))", "  case $words[1] in"});
  for (const HelpPage& page : pages.subspan(1)) {
    if (is_task(page.command)) continue;
    if (page.commands.empty()) {
      add_branch(lines, page, pages, "    ");
      continue;
    }
    lines.push_back(fmt::format("    {})", page.command.name));
    add_described(lines, "tasks", page.commands, "      ");
    const std::string no_task = fmt::format(" || [[ $words[2] != ({}) ]]", fmt::join(words_behind(page, pages), "|"));
    lines.insert(lines.end(), {fmt::format("      if ((CURRENT == 2)){}; then", page.takes_input ? no_task : ""),
                               "        ((CURRENT > 2)) || _describe task tasks", "        _arguments \\"});
    add_options(lines, page, "          ");
    lines.insert(lines.end(), {page.takes_input ? "          '*:input:_files'" : "          '*: : '", "        return", "      fi",
                               "      shift words", "      ((CURRENT--))", "      case $words[1] in"});
    for (const HelpPage& task : pages)
      if (is_task(task.command) && task.command.name.starts_with(page.command.name)) add_branch(lines, task, pages, "        ");
    lines.insert(lines.end(), {"      esac", "      ;;"});
  }
  lines.insert(lines.end(), {"  esac", "}", "if [[ $funcstack[1] == _fathom ]]; then _fathom \"$@\"; else compdef _fathom fathom; fi"});
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace fathom::cli
