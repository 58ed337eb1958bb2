// SPDX-License-Identifier: GPL-3.0-or-later
// Completion of commands, options and their values in bash, zsh and fish, made of the pages of
// help.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/args/words.hpp"
#include "cli/manual/manual.hpp"

namespace fathom::cli {
namespace {

using Lines = std::vector<std::string>;

constexpr std::string_view made_by = "# Commands, options and values of fathom; made by `fathom completion`.";

/// What may stand behind an option.
enum class ValueKind { none, words, list, file, folder, other };

ValueKind value_kind(const OptionHelp& option) {
  if (!option.choices.empty()) return option.value == "FLAGS" ? ValueKind::list : ValueKind::words;
  if (option.value.empty() || option.value.front() == '[') return ValueKind::none;
  if (option.value == "DIR") return ValueKind::folder;
  return option.value == "FILE" || option.value == "CASES" || option.value == "Q" ? ValueKind::file : ValueKind::other;
}

/// The words, none of which is an option, that may stand behind the command; empty if only files
/// do.
std::vector<std::string> words_behind(const HelpPage& page, std::span<const HelpPage> pages) {
  std::vector<std::string> words;
  if (page.command.name == "completion") return {std::begin(shells), std::end(shells)};
  const HelpPage& source = page.command.name == "help" || page.command.name == "man" ? pages.front() : page;
  for (const CommandHelp& command : source.commands) words.emplace_back(last_word(command));
  return words;
}

/// The beginning of a meaning, up to the first stop, in one line.
std::string short_meaning(std::string_view meaning) {
  constexpr std::size_t longest = 70;
  std::string text(meaning.substr(0, std::min(meaning.find(". "), meaning.find("; "))));
  std::ranges::replace(text, '\n', ' ');
  if (text.size() <= longest) return text;
  return text.substr(0, text.rfind(' ', longest)) + " ...";
}

/// `text` with a backslash before each of the characters.
std::string escaped(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != characters.npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

// ---- bash ----

namespace {

std::string bash_options(const HelpPage& page) {
  Lines names;
  for (const OptionHelp& option : page.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

/// What is offered behind an option.
std::string bash_offer(const OptionHelp& option) {
  switch (value_kind(option)) {
    case ValueKind::words: return fmt::format("words='{}'", fmt::join(option.choices, " "));
    case ValueKind::list: return fmt::format("list='{}'", fmt::join(option.choices, " "));
    case ValueKind::file: return "files=-f";
    case ValueKind::folder: return "files=-d";
    default: return "return";
  }
}

void add_bash_values(Lines& lines, const HelpPage& page) {
  for (const OptionHelp& option : page.options) {
    if (value_kind(option) == ValueKind::none) continue;
    Lines names;
    for (const std::string& name : option.names) names.push_back(fmt::format("'{}:{}'", page.command.name, name));
    lines.push_back(fmt::format("    {}) {} ;;", fmt::join(names, " | "), bash_offer(option)));
  }
}

}  // namespace

std::string bash_completion(std::span<const HelpPage> pages) {
  Lines values, words;
  for (const HelpPage& page : pages) {
    add_bash_values(values, page);
    const Lines behind = words_behind(page, pages);
    words.push_back(fmt::format("    '{}') options='{}' {}{} ;;", page.command.name, bash_options(page),
                                behind.empty() || page.takes_input ? "files=-f " : "",
                                behind.empty() ? "" : fmt::format("words='{}'", fmt::join(behind, " "))));
  }
  const auto tasks = [&] {
    Lines names;
    for (const HelpPage& page : pages)
      if (is_task(page.command)) names.push_back(fmt::format("'{}'", page.command.name));
    return fmt::format("{}", fmt::join(names, " | "));
  };
  return fmt::format(R"(# shellcheck shell=bash
{made_by}
_fathom() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} page= words= list= options= files= typed=
  COMPREPLY=()
  if [[ $word == = ]]; then # bash takes --name=value apart
    word=
  elif [[ $before == = ]]; then
    before=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  if ((COMP_CWORD > 1)); then page=${{COMP_WORDS[1]}}; fi
  if ((COMP_CWORD > 2)); then
    case "$page ${{COMP_WORDS[2]}}" in
      {tasks}) page+=" ${{COMP_WORDS[2]}}" ;;
    esac
  fi
  case $page:$before in
{values}
    *)
      case $page in
{words}
      esac
      ;;
  esac
  if [[ $word == -* ]]; then words=$options files=; fi
  if [[ -n $files ]]; then mapfile -t COMPREPLY < <(compgen "$files" -- "$word"); fi
  if [[ -n $list ]]; then
    typed=${{word%"${{word##*,}}"}} # with commas between them
    mapfile -t COMPREPLY < <(compgen -P "$typed" -W "$list" -- "${{word##*,}}")
  fi
  if [[ -n $words ]]; then mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -W "$words" -- "$word"); fi
}}
complete -o filenames -F _fathom fathom)",
                     fmt::arg("made_by", made_by), fmt::arg("tasks", tasks()),
                     fmt::arg("values", fmt::join(values, "\n")), fmt::arg("words", fmt::join(words, "\n")));
}

// ---- zsh ----

namespace {

/// What _arguments is to offer for a value.
std::string zsh_action(const OptionHelp& option) {
  switch (value_kind(option)) {
    case ValueKind::words: return fmt::format(":{}:({})", option.value, fmt::join(option.choices, " "));
    case ValueKind::list:
      return fmt::format(":{}:_sequence -s , compadd - {}", option.value, fmt::join(option.choices, " "));
    case ValueKind::file: return fmt::format(":{}:_files", option.value);
    case ValueKind::folder: return fmt::format(":{}:_files -/", option.value);
    case ValueKind::other: return fmt::format(":{}: ", escaped(option.value, ":"));
    case ValueKind::none: break;
  }
  return "";
}

/// "    '--method=[how]:NAME:(auto exact)' \" for each name.
void add_zsh_options(Lines& lines, const HelpPage& page, const std::string& indent) {
  for (const OptionHelp& option : page.options)
    for (const std::string& name : option.names) {
      const bool takes_value = value_kind(option) != ValueKind::none;
      const std::string spec = fmt::format("{}{}[{}]{}", name, takes_value && name.starts_with("--") ? "=" : "",
                                           escaped(short_meaning(option.meaning), "[]:\\"), zsh_action(option));
      lines.push_back(fmt::format("{}{} \\", indent, quoted(spec)));
    }
}

/// One branch: the options, then words or files.
void add_branch(Lines& lines, const HelpPage& page, std::span<const HelpPage> pages, const std::string& indent) {
  const Lines behind = words_behind(page, pages);
  lines.push_back(fmt::format("{}{})", indent, last_word(page.command)));
  lines.push_back(indent + "  _arguments \\");
  add_zsh_options(lines, page, indent + "    ");
  lines.push_back(fmt::format(
      "{}    {}", indent, behind.empty() ? "'*:input:_files'" : fmt::format("'1:word:({})'", fmt::join(behind, " "))));
  lines.push_back(indent + "  ;;");
}

void add_described(Lines& lines, const std::string& name, std::span<const CommandHelp> commands,
                   const std::string& indent) {
  lines.push_back(fmt::format("{}{}=(", indent, name));
  for (const CommandHelp& command : commands)
    lines.push_back(fmt::format("{}  {}", indent,
                                quoted(fmt::format("{}:{}", last_word(command), escaped(command.summary, ":\\")))));
  lines.push_back(indent + ")");
}

}  // namespace

std::string zsh_completion(std::span<const HelpPage> pages) {
  Lines lines = {"#compdef fathom", std::string(made_by), "_fathom() {", "  local -a commands tasks"};
  add_described(lines, "commands", pages.front().commands, "  ");
  lines.insert(lines.end(), {"  if ((CURRENT == 2)); then", "    _describe command commands", "    _arguments \\"});
  add_zsh_options(lines, pages.front(), "      ");
  lines.insert(lines.end(),
               {"      '*: : '", "    return", "  fi", "  shift words", "  ((CURRENT--))", "  case $words[1] in"});
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
    add_zsh_options(lines, page, "          ");
    lines.insert(lines.end(), {page.takes_input ? "          '*:input:_files'" : "          '*: : '", "        return",
                               "      fi", "      shift words", "      ((CURRENT--))", "      case $words[1] in"});
    for (const HelpPage& task : pages)
      if (is_task(task.command) && task.command.name.starts_with(page.command.name))
        add_branch(lines, task, pages, "        ");
    lines.insert(lines.end(), {"      esac", "      ;;"});
  }
  lines.insert(
      lines.end(),
      {"  esac", "}", "if [[ $funcstack[1] == _fathom ]]; then _fathom \"$@\"; else compdef _fathom fathom; fi"});
  return fmt::format("{}", fmt::join(lines, "\n"));
}

// ---- fish ----

namespace {

std::string fish_quoted(std::string_view text) { return "'" + escaped(text, "'\\") + "'"; }

/// What must have been typed for the page to be meant.
std::string fish_condition(const HelpPage& page) {
  if (page.command.name.empty()) return "__fish_use_subcommand";
  std::string result =
      "__fish_seen_subcommand_from " + std::string(page.command.name.substr(0, page.command.name.find(' ')));
  if (is_task(page.command)) result += fmt::format("; and __fish_seen_subcommand_from {}", last_word(page.command));
  return result;
}

void add_fish_options(Lines& lines, const HelpPage& page) {
  for (const OptionHelp& option : page.options) {
    std::string line = "complete -c fathom -n " + fish_quoted(fish_condition(page));
    for (const std::string& name : option.names)
      line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
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
void add_fish_words(Lines& lines, const HelpPage& page, std::span<const HelpPage> pages) {
  const Lines behind = words_behind(page, pages);
  if (behind.empty()) return;
  std::string when = fish_condition(page);
  if (!page.command.name.empty())
    when += fmt::format("; and not __fish_seen_subcommand_from {}", fmt::join(behind, " "));
  // Behind `help`, which is a command too, the others have not been typed yet.
  if (page.command.name == "help" || page.command.name == "man") when = fish_condition(page);
  if (page.commands.empty())
    lines.push_back(fmt::format("complete -c fathom -f -n {} -a '{}'", fish_quoted(when), fmt::join(behind, " ")));
  for (const CommandHelp& command : page.commands)
    lines.push_back(fmt::format("complete -c fathom{} -n {} -a {} -d {}", page.takes_input ? "" : " -f",
                                fish_quoted(when), last_word(command), fish_quoted(command.summary)));
}

}  // namespace

std::string fish_completion(std::span<const HelpPage> pages) {
  Lines lines = {std::string(made_by)};
  for (const HelpPage& page : pages) {
    add_fish_words(lines, page, pages);
    add_fish_options(lines, page);
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace fathom::cli
