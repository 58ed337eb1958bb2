// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/args/parser_words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <sstream>
#include <utility>

#include "cli/args/words.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t longest_sentence = 200;
constexpr std::size_t longest_list = 4000;  // our own checks list what is known, and show of what was typed a readable part

/// The words that one_of() has left with the option.
std::vector<std::string> choices_of(CLI::Option& option) {
  try {
    std::istringstream words(option.get_validator(0)->get_name());
    return {std::istream_iterator<std::string>(words), {}};
  } catch (const CLI::OptionNotFound&) {  // it has no check at all
    return {};
  }
}

/// The first option that is unknown, as it was typed, or "".
std::string unknown_option(const CLI::App& app) {
  for (const std::string& word : app.remaining(true))
    if (word.starts_with('-') && word != "--") return word.substr(0, word.find('='));
  return "";
}

/// What may be meant by an option that is unknown, or "".
std::string suggestion(CLI::App& app, CLI::App* asked) {
  std::vector<std::string> names;
  for (const OptionHelp& option : options_of(asked ? *asked : app)) names.insert(names.end(), option.names.begin(), option.names.end());
  const std::string typed = unknown_option(app);
  if (std::ranges::find(names, typed) != names.end()) return fmt::format("; {} stands behind the command", typed);
  return typed.empty() ? "" : did_you_mean(typed, names);
}

}  // namespace

CLI::Validator one_of(std::vector<std::string> words, std::function<std::string(const std::string&)> check) {
  const auto wrong = [check = std::move(check)](const std::string& value) { return check(value); };
  return {wrong, "", fmt::format("{}", fmt::join(words, " "))};  // its name is the one place where a check can keep them
}

CLI::Validator one_of(std::vector<std::string> words) {
  const auto check = [words](const std::string& value) -> std::string {
    if (std::ranges::find(words, value) != words.end()) return "";
    return fmt::format("{} is unknown (expected {}){}", kernels::shown(value), fmt::join(words, ", "), did_you_mean(value, words));
  };
  return one_of(words, check);
}

std::vector<OptionHelp> options_of(CLI::App& app) {
  std::vector<OptionHelp> options;
  for (CLI::Option* option : app.get_options()) {
    if (!option->nonpositional()) continue;
    OptionHelp help{{}, option->get_type_name(), option->get_description(), choices_of(*option)};
    for (const std::string& name : option->get_snames()) help.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) help.names.push_back("--" + name);
    if (option->get_required()) help.meaning += "; required";
    options.push_back(std::move(help));
  }
  return options;
}

std::string sentence(const CLI::ParseError& error, CLI::App& app, CLI::App* asked) {
  const bool of_a_check = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr;
  const std::string text = kernels::printable(error.what(), of_a_check ? longest_list : longest_sentence);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return text + suggestion(app, asked);
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && !unknown_option(app).empty())  // misspelt, perhaps
    return fmt::format("{}, and {} is not expected{}", text, kernels::shown(unknown_option(app)), suggestion(app, asked));
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return text;
  return text.substr(0, text.find(':')) + ": expected one value, once";
}

std::string missing_value(std::span<const std::string> words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word.starts_with("--") && word.find('=') == word.size() - 1) return kernels::shown(word) + " lacks its value";
  }
  return "";
}

std::string empty_value(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const auto& values = option->results();
    if (option->nonpositional() && std::find(values.begin(), values.end(), "") != values.end())
      return option->get_name() + " expects a value, found nothing";
  }
  return "";
}

}  // namespace fathom::cli
