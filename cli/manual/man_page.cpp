// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "cli/manual/manual.hpp"

namespace fathom::cli {
namespace {

using Lines = std::vector<std::string>;

/// Text that roff prints as it is, in one line.
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

/// The summary as man's index has it: "exact width of one body".
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

/// The sections of a page that its tasks have too, as subsections.
void add_sections(Lines& lines, const HelpPage& page, const char* section) {
  const auto heading = [&](const char* title) { lines.push_back(fmt::format("{} {}", section, title)); };
  heading("OPTIONS");
  add_options(lines, page.options);
  heading("EXAMPLES");
  add_examples(lines, page.command.examples);
}

}  // namespace

std::string man_name(const CommandHelp& command) {
  std::string name = full_name(command);
  std::ranges::replace(name, ' ', '-');
  return name;
}

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

}  // namespace fathom::cli
