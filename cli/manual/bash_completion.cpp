// SPDX-License-Identifier: GPL-3.0-or-later
// The part of completion.hpp for bash.
#include "cli/manual/manual.hpp"

namespace fathom::cli {
namespace {

using Lines = std::vector<std::string>;

std::string option_words(const HelpPage& page) {
  Lines names;
  for (const OptionHelp& option : page.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

/// What is offered behind an option.
std::string offer(const OptionHelp& option) {
  switch (value_kind(option)) {
    case ValueKind::words: return fmt::format("words='{}'", fmt::join(option.choices, " "));
    case ValueKind::list: return fmt::format("list='{}'", fmt::join(option.choices, " "));
    case ValueKind::file: return "files=-f";
    case ValueKind::folder: return "files=-d";
    default: return "return";
  }
}

void add_values(Lines& lines, const HelpPage& page) {
  for (const OptionHelp& option : page.options) {
    if (value_kind(option) == ValueKind::none) continue;
    Lines names;
    for (const std::string& name : option.names) names.push_back(fmt::format("'{}:{}'", page.command.name, name));
    lines.push_back(fmt::format("    {}) {} ;;", fmt::join(names, " | "), offer(option)));
  }
}

}  // namespace

std::string bash_completion(std::span<const HelpPage> pages) {
  Lines values, words;
  for (const HelpPage& page : pages) {
    add_values(values, page);
    const Lines behind = words_behind(page, pages);
    words.push_back(fmt::format("    '{}') options='{}' {}{} ;;", page.command.name, option_words(page),
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
                     fmt::arg("made_by", made_by), fmt::arg("tasks", tasks()), fmt::arg("values", fmt::join(values, "\n")),
                     fmt::arg("words", fmt::join(words, "\n")));
}

}  // namespace fathom::cli
