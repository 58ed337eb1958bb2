// SPDX-License-Identifier: GPL-3.0-or-later
// What CLI11 prints for fathom: help that starts with examples, and plain sentences.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "kernels/printable.hpp"

namespace fathom::cli {

/// Help with examples first and a synopsis written by hand.
class ExamplesFirst : public CLI::Formatter {
 public:
  ExamplesFirst(std::string_view examples, std::string_view synopsis) : examples_(examples), synopsis_(synopsis) { column_width(34); }
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    if (mode != CLI::AppFormatMode::Normal) return Formatter::make_help(app, std::move(name), mode);
    const std::string rest = Formatter::make_help(app, std::move(name), mode);
    return examples_ + '\n' + rest.substr(0, rest.find_last_not_of('\n') + 1);
  }
  std::string make_usage(const CLI::App*, std::string) const override { return "Usage: " + synopsis_ + '\n'; }
  std::string make_positionals(const CLI::App*) const override { return ""; }

 private:
  std::string examples_, synopsis_;
};

/// Returns CLI11's sentence, or a plainer one.
inline std::string sentence(const CLI::ParseError& error) {
  const std::string text = kernels::printable(error.what(), 200);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return text;
  return text.substr(0, text.find(':')) + ": expected one value, once";
}

/// Returns what is wrong with a word like "--name=", whose value CLI11 would take from the next word, or "".
inline std::string missing_value(std::span<const std::string> words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word.starts_with("--") && word.find('=') == word.size() - 1) return kernels::shown(word) + " lacks its value";
  }
  return "";
}

/// Returns what is wrong if an option of `command` has an empty value, which would count as not given, or "".
inline std::string empty_value(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const auto& values = option->results();
    if (option->nonpositional() && std::find(values.begin(), values.end(), "") != values.end())
      return option->get_name() + " expects a value, found nothing";
  }
  return "";
}

}  // namespace fathom::cli
