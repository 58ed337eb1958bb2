// SPDX-License-Identifier: GPL-3.0-or-later
// fathom help [COMMAND] | man [COMMAND] | man --all DIR | completion SHELL

#include "cli/args/help.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "cli/args/help_page.hpp"
#include "cli/args/options.hpp"
#include "cli/args/words.hpp"
#include "cli/commands/adapters.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/family_names.hpp"
#include "cli/io/output.hpp"
#include "cli/io/terminal.hpp"
#include "cli/manual/manual.hpp"
#include "kernels/messages.hpp"
#include "reference/files/file_io.hpp"
#include "verify/families/families.hpp"

namespace fathom::cli {
namespace {

using Pages = std::vector<HelpPage>;

/// Adds the values of options that the parser does not know, as fathom-depth has it too.
void add_values(HelpPage& page) {
  for (OptionHelp& option : page.options) {
    std::vector<std::string>& values = option.choices;
    const std::string& name = option.names.back();
    if (name == "--adapter") std::ranges::transform(adapters(), std::back_inserter(values), &Adapter::name);
    if (name == "--family") {
      values.emplace_back("all");
      for (const std::string_view family : family_names()) values.emplace_back(family);
    }
    if (name == "--sweep")
      std::ranges::transform(families::families(), std::back_inserter(values),
                             [](const auto& family) { return std::string(family.name); });
  }
}

/// Every page: that of fathom first, then the commands in the order of the table, each with its
/// tasks behind it.
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

/// The page of this name, or nullptr.
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
    } catch (const std::system_error& error) {
      throw OutputError(path + ": cannot be written: " + error.code().message());
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

ExitCode run_help(std::string_view name, const std::vector<std::string>& words) {
  const Pages pages = all_pages();
  const bool about_itself =
      std::ranges::any_of(words, [](const std::string& word) { return word == "-h" || word == "--help"; });
  if (about_itself) return help(pages, name);
  if (name == "man") return man(pages, words);
  if (name == "completion") return completion(pages, words);
  return help(pages, fmt::format("{}", fmt::join(words, " ")));
}

}  // namespace fathom::cli
