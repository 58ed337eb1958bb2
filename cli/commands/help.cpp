// SPDX-License-Identifier: GPL-3.0-or-later
// fathom help [COMMAND] | man [COMMAND] | man --all DIR | completion SHELL
// Pages of help for terminals; as roff, for man; and scripts with which shells complete commands,
// options and their values.

#include "cli/args/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "cli/args/arguments.hpp"
#include "cli/args/values.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/names.hpp"
#include "cli/io/output.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "verify/families/families.hpp"

namespace fathom::cli {

namespace {

using Lines = std::vector<std::string>;

constexpr const char* shells[] = {"bash", "zsh", "fish"};

/// Returns whether it is a task of another command: "golden verify".
bool is_task(const CommandHelp& command) { return !parent(command).empty(); }

// ---- manual pages ----

/// Returns the text as one line, escaped for roff.
std::string plain(std::string_view text) {
  std::string result = !text.empty() && text.front() == '.' ? "\\&" : "";
  for (const char c : text) {
    switch (c) {
      case '\\': result += "\\e"; break;
      case '-': result += "\\-"; break;
      case '\'': result += "\\(aq"; break;
      case '`': result += "\\(ga"; break;
      case '^': result += "\\(ha"; break;
      case '~': result += "\\(ti"; break;
      case '\n': result += ' '; break;
      default: result += c;
    }
  }
  return result;
}

std::string bold(std::string_view text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(std::string_view text) { return text.empty() ? "" : "\\fI" + plain(text) + "\\fR"; }

/// Returns the summary in the form of man's index: "exact width of one body".
std::string line_of_index(std::string_view summary) {
  std::string result(summary.substr(0, summary.find_last_not_of('.') + 1));
  if (!result.empty() && result.front() >= 'A' && result.front() <= 'Z')
    result.front() = static_cast<char>(result.front() - 'A' + 'a');
  return plain(result);
}

void add_tagged(Lines& lines, std::string tag, std::string_view meaning) {
  lines.insert(lines.end(), {".TP", std::move(tag), plain(meaning)});
}

void add_options(Lines& lines, std::span<const OptionHelp> options) {
  for (const OptionHelp& option : options) {
    Lines names;
    for (const std::string& name : option.names) names.push_back(bold(name));
    const bool may_miss = !option.value.empty() && option.value.front() == '[';
    add_tagged(lines,
               fmt::format("{}{}{}", fmt::join(names, ", "), option.value.empty() || may_miss ? "" : " ",
                           italic(option.value)),
               option.meaning);
  }
}

void add_examples(Lines& lines, std::span<const Example> examples) {
  for (const Example& example : examples) {
    lines.insert(lines.end(),
                 {".PP", plain(example.meaning), ".PP", ".RS 4", ".EX", plain(example.line), ".EE", ".RE"});
  }
}

/// Adds the sections that pages of commands and of tasks both have; for a task as subsections.
void add_sections(Lines& lines, const HelpPage& page, const char* section) {
  const auto heading = [&](const char* title) { lines.push_back(fmt::format("{} {}", section, title)); };
  heading("OPTIONS");
  add_options(lines, page.options);
  heading("EXAMPLES");
  add_examples(lines, page.command.examples);
}

/// Returns "fathom", "fathom-depth".
std::string man_name(const CommandHelp& command) {
  std::string name = full_name(command);
  std::ranges::replace(name, ' ', '-');
  return name;
}

/// Returns the page as roff with the macros of man, followed by those of the command's tasks,
/// without the last newline. `others`: the pages to refer to.
std::string man_page(const HelpPage& page, std::span<const HelpPage> tasks, std::span<const std::string> others) {
  const CommandHelp& command = page.command;
  const std::string name = man_name(command);
  std::string title = name;
  for (char& c : title) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  Lines lines = {fmt::format(".TH \"{}\" 1 \"\" \"fathom {}\" \"User Commands\"", plain(title), FATHOM_VERSION),
                 ".SH NAME",
                 plain(name) + " \\- " + line_of_index(command.summary),
                 ".SH SYNOPSIS",
                 plain(command.synopsis),
                 ".SH DESCRIPTION"};
  for (const std::string_view note : command.notes) lines.insert(lines.end(), {".PP", plain(note)});
  if (!page.commands.empty()) lines.emplace_back(".SH COMMANDS");
  for (const CommandHelp& below : page.commands) add_tagged(lines, bold(last_word(below)), below.summary);
  add_sections(lines, page, ".SH");
  for (const HelpPage& task : tasks) {
    std::string heading = full_name(task.command);
    lines.insert(lines.end(),
                 {".SH " + plain(heading), plain(task.command.summary), ".PP", plain(task.command.synopsis)});
    add_sections(lines, task, ".SS");
  }
  lines.emplace_back(".SH EXIT STATUS");
  for (const auto& [code, meaning] : command.exits) add_tagged(lines, bold(std::to_string(code)), meaning);
  lines.emplace_back(".SH SEE ALSO");
  Lines references;
  for (const std::string& other : others)
    if (other != name) references.push_back(bold(other) + "(1)");
  lines.push_back(fmt::format("{}", fmt::join(references, ", ")));
  return fmt::format("{}", fmt::join(lines, "\n"));
}

// ---- completion: scripts for shells, made from all pages, that of fathom first, each command's
// before those of its tasks; without the last newline ----

constexpr std::string_view made_by = "# Commands, options and values of fathom; made by `fathom completion`.";

/// The kind of word that follows an option.
enum class ValueKind { none, words, list, file, folder, other };

ValueKind value_kind(const OptionHelp& option) {
  if (!option.choices.empty()) return option.value == "FLAGS" ? ValueKind::list : ValueKind::words;
  if (option.value.empty() || option.value.front() == '[') return ValueKind::none;
  if (option.value == "DIR") return ValueKind::folder;
  return option.value == "FILE" || option.value == "CASES" || option.value == "Q" ? ValueKind::file : ValueKind::other;
}

/// Returns the words, other than options, that may follow the command; empty if only files may.
std::vector<std::string> words_behind(const HelpPage& page, std::span<const HelpPage> pages) {
  std::vector<std::string> words;
  if (page.command.name == "completion") return {std::begin(shells), std::end(shells)};
  const HelpPage& source = page.command.name == "help" || page.command.name == "man" ? pages.front() : page;
  for (const CommandHelp& command : source.commands) words.emplace_back(last_word(command));
  return words;
}

/// Returns the beginning of a meaning, up to the first full stop, in one line.
std::string short_meaning(std::string_view meaning) {
  constexpr std::size_t longest = 70;
  std::string text(meaning.substr(0, std::min(meaning.find(". "), meaning.find("; "))));
  std::ranges::replace(text, '\n', ' ');
  if (text.size() <= longest) return text;
  return text.substr(0, text.rfind(' ', longest)) + " ...";
}

/// Returns `text` with a backslash before each of the characters.
std::string escaped(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != characters.npos) result += '\\';
    result += c;
  }
  return result;
}

// ---- bash ----

std::string bash_options(const HelpPage& page) {
  Lines names;
  for (const OptionHelp& option : page.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

/// Returns the completions for the value of an option.
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

/// Returns the action of _arguments for a value.
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

/// Adds "    '--method=[how]:NAME:(auto exact)' \" for each name.
void add_zsh_options(Lines& lines, const HelpPage& page, const std::string& indent) {
  for (const OptionHelp& option : page.options)
    for (const std::string& name : option.names) {
      const bool takes_value = value_kind(option) != ValueKind::none;
      const std::string spec = fmt::format("{}{}[{}]{}", name, takes_value && name.starts_with("--") ? "=" : "",
                                           escaped(short_meaning(option.meaning), "[]:\\"), zsh_action(option));
      lines.push_back(fmt::format("{}{} \\", indent, quoted(spec)));
    }
}

/// Adds one branch of the script: the options, then words or files.
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

std::string fish_quoted(std::string_view text) { return "'" + escaped(text, "'\\") + "'"; }

/// Returns the condition under which the words typed so far select the page.
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

/// Adds the words that may follow the command, each once; commands with their summaries.
void add_fish_words(Lines& lines, const HelpPage& page, std::span<const HelpPage> pages) {
  const Lines behind = words_behind(page, pages);
  if (behind.empty()) return;
  std::string when = fish_condition(page);
  if (!page.command.name.empty())
    when += fmt::format("; and not __fish_seen_subcommand_from {}", fmt::join(behind, " "));
  // `help` is itself a word that it takes, so its condition must not exclude words that were typed.
  if (page.command.name == "help" || page.command.name == "man") when = fish_condition(page);
  if (page.commands.empty())
    lines.push_back(fmt::format("complete -c fathom -f -n {} -a '{}'", fish_quoted(when), fmt::join(behind, " ")));
  for (const CommandHelp& command : page.commands)
    lines.push_back(fmt::format("complete -c fathom{} -n {} -a {} -d {}", page.takes_input ? "" : " -f",
                                fish_quoted(when), last_word(command), fish_quoted(command.summary)));
}

std::string fish_completion(std::span<const HelpPage> pages) {
  Lines lines = {std::string(made_by)};
  for (const HelpPage& page : pages) {
    add_fish_words(lines, page, pages);
    add_fish_options(lines, page);
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

// ---- the commands ----

using Pages = std::vector<HelpPage>;

/// Adds the values of options that are not in the table of fathom-depth.
void add_values(HelpPage& page) {
  for (OptionHelp& option : page.options) {
    std::vector<std::string>& values = option.choices;
    const std::string& name = option.names.back();
    if (name == "--adapter") std::ranges::transform(adapters(), std::back_inserter(values), &Adapter::name);
    if (name == "--family") {
      values.emplace_back("all");
      for (const std::string_view family : families::family_names()) values.emplace_back(family);
    }
    if (name == "--sweep")
      std::ranges::transform(families::families(), std::back_inserter(values),
                             [](const auto& family) { return std::string(family.name); });
  }
}

/// Returns all pages: that of fathom first, then the commands in the order of the table, each
/// followed by its tasks.
Pages all_pages() {
  std::vector<Option> table(common_options().begin(), common_options().end());
  std::ranges::copy(golden_options(), std::back_inserter(table));
  Pages pages = {page_of("", table)};
  for (const CommandHelp& command : command_table) pages.push_back(page_of(command.name, table));
  std::ranges::for_each(pages, add_values);
  return pages;
}

ExitCode refused(std::string_view name, const std::string& sentence) {
  talk(fmt::format("{}\nTry: fathom {} --help", sentence, name));
  return bad_input;
}

/// Returns the page of this name, or nullptr.
const HelpPage* find_page(const Pages& pages, std::string_view name) {
  const auto found = std::ranges::find(pages, name, [](const HelpPage& page) { return page.command.name; });
  return found == pages.end() ? nullptr : &*found;
}

std::string unknown_command(const Pages& pages, const std::string& words) {
  std::vector<std::string> names;
  for (const HelpPage& page : pages)
    if (!page.command.name.empty()) names.emplace_back(page.command.name);
  return fmt::format("unknown command {} (expected {}){}", kernels::shown(words), fmt::join(command_names(), ", "),
                     did_you_mean(words, names));
}

std::string man_text(const Pages& pages, const HelpPage& page) {
  Pages tasks;
  std::vector<std::string> names;
  for (const HelpPage& other : pages) {
    if (!is_task(other.command)) names.push_back(man_name(other.command));
    else if (other.command.name.starts_with(std::string(page.command.name) + ' ')) tasks.push_back(other);
  }
  return man_page(page, tasks, names);
}

/// Writes fathom.1, fathom-depth.1 and so on.
void write_pages(const Pages& pages, const std::string& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  for (const HelpPage& page : pages) {
    if (is_task(page.command)) continue;
    const std::string path = (std::filesystem::path(folder) / (man_name(page.command) + ".1")).string();
    try {
      files::WholeFile file(path);
      file.write(man_text(pages, page) + '\n');
      file.put_in_place();
    } catch (const files::FileError& error) {
      throw OutputError(path + ": cannot be written: " + error.code.message());
    }
  }
}

ExitCode man(const Pages& pages, std::vector<std::string> words) {
  const std::string first = words.empty() ? "" : words[0];
  if (first.starts_with("--all")) {
    constexpr std::string_view joined = "--all=";
    if (first.starts_with(joined)) words = {"--all", first.substr(joined.size())};
    if (words[0] != "--all" || words.size() != 2 || words[1].empty())
      return refused("man", "--all expects a folder, and nothing else");
    write_pages(pages, words[1]);
    return fine;
  }
  const HelpPage* const page = find_page(pages, first);
  if (page == nullptr || words.size() > 1)
    return refused("man", unknown_command(pages, fmt::format("{}", fmt::join(words, " "))));
  print(man_text(pages, *page));
  return fine;
}

ExitCode completion(const Pages& pages, const std::vector<std::string>& words) {
  const std::string shell = fmt::format("{}", fmt::join(words, " "));
  if (shell == "bash") print(bash_completion(pages));
  else if (shell == "zsh") print(zsh_completion(pages));
  else if (shell == "fish") print(fish_completion(pages));
  else {
    const std::vector<std::string> known(std::begin(shells), std::end(shells));
    return refused("completion", fmt::format("completion expects a shell: {}; found {}{}", fmt::join(known, ", "),
                                             kernels::shown(shell), did_you_mean(shell, known)));
  }
  return fine;
}

ExitCode help(const Pages& pages, std::string_view asked) {
  const HelpPage* const page = find_page(pages, asked);
  if (page == nullptr) return refused("help", unknown_command(pages, std::string(asked)));
  print(help_text(*page, help_columns(STDOUT_FILENO)));
  return fine;
}

}  // namespace

ExitCode run_help(const Given& given) {
  const auto& [name, words] = std::tie(given.command, given.rest);
  const Pages pages = all_pages();
  const bool about_itself =
      std::ranges::any_of(words, [](const std::string& word) { return word == "-h" || word == "--help"; });
  if (about_itself) return help(pages, name);
  if (name == "man") return man(pages, words);
  if (name == "completion") return completion(pages, words);
  return help(pages, fmt::format("{}", fmt::join(words, " ")));
}

}  // namespace fathom::cli
