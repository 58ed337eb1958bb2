// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that knows CLI11: it makes the parser from the table.
#include "cli/args/given.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>

#include "cli/args/help.hpp"
#include "cli/args/help_page.hpp"
#include "cli/args/values.hpp"
#include "cli/args/words.hpp"
#include "kernels/messages.hpp"

namespace fathom::cli {
namespace {

constexpr std::size_t longest_sentence = 200;
constexpr std::size_t longest_list =
    4000;  // our own checks list what is known, and show of what was typed a readable part

std::string wrong_word(const std::string& value, const std::vector<std::string>& words) {
  if (std::ranges::find(words, value) != words.end()) return "";
  const std::string shown = value.empty() ? "the empty value" : kernels::shown(value);
  return fmt::format("{} is unknown (expected {}){}", shown, fmt::join(words, ", "), did_you_mean(value, words));
}

/// What is wrong with a value of the option, or "".
std::string wrong_value(const Option& option, const std::string& value) {
  if (option.values.wrong) return option.values.wrong(value);
  if (option.values.words.empty()) return "";
  const std::vector<std::string> words =
      option.repeats == Repeats::lists ? words_of(value) : std::vector<std::string>{value};
  for (const std::string& word : words)
    if (std::string fault = wrong_word(word, option.values.words); !fault.empty()) return fault;
  return "";
}

/// The parser of one command line, with the places that it fills in.
class Parser {
 public:
  Parser(std::string before, std::span<const Option> table)
      : before_(std::move(before)), table_(table), app_("", full_name({before_, "", "", {}, {}})) {
    if (before_.empty()) app_.set_version_flag("-V,--version", "");
    app_.require_subcommand(0, 1);  // so that a file may be called "width"
    add_options(app_, before_);
    for (const CommandHelp& command : command_table)
      if (parent(command) == before_ && !parses_itself(command.name)) add_command(command);
  }

  Given read(const std::vector<std::string>& words) {
    Given given;
    given.command = before_;
    try {
      app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::CallForHelp&) {
      given.kind = Given::Kind::help;
    } catch (const CLI::CallForVersion&) {
      given.kind = Given::Kind::version;
    } catch (const CLI::ParseError& error) {
      given.kind = Given::Kind::refused;
      given.fault = sentence(error);
    }
    if (!asked().empty()) given.command = asked();
    if (given.kind != Given::Kind::request) return given;
    for (const Place& place : places_)
      if (place.command == given.command)
        given.options.push_back({place.option, place.parsed->get_name(), place.values()});
    return given;
  }

 private:
  /// An option of a command in the parser.
  struct Place {
    std::string command;
    const Option* option;
    CLI::Option* parsed;
    const bool* flag = nullptr;                           ///< its value, if it is one
    const std::vector<std::string>* values_of = nullptr;  ///< of one that is given each time anew

    [[nodiscard]] std::vector<std::string> values() const {
      if (values_of) return *values_of;
      if (!flag || parsed->count() == 0) return parsed->results();
      return {*flag ? "true" : "false"};
    }
  };

  void add_command(const CommandHelp& command) {
    CLI::App& app = *app_.add_subcommand(std::string(last_word(command)), "");
    commands_.emplace_back(command.name, &app);
    add_options(app, std::string(command.name));
  }

  void add_options(CLI::App& app, const std::string& command) {
    for (const Option& option : table_)
      if (option.belongs_to(command)) add_option(app, option, command);
  }

  void add_option(CLI::App& app, const Option& option, const std::string& command) {
    const bool flag = !option.is_input() && option.is_flag();
    if (flag && option.value.empty()) {
      bool& set = flags_.emplace_back(false);
      places_.push_back({command, &option, app.add_flag(option.names, set), &set});
      return;
    }
    if (flag) {
      places_.push_back({command, &option, app.add_flag(option.names, texts_.emplace_back())});
      return;
    }
    // One by one: into a vector, CLI11 would take a file called "[x]" for a list.
    const auto one = [](const std::string&) {};
    std::vector<std::string>* each = nullptr;
    const auto several = [](const std::vector<std::string>&) {};
    CLI::Option* added = nullptr;
    if (option.repeats == Repeats::lists || (option.is_input() && option.repeats == Repeats::each))
      added = app.add_option_function<std::vector<std::string>>(option.names, several);
    else if (option.repeats == Repeats::each) {
      each = &lists_.emplace_back();
      added = app.add_option_function<std::string>(option.names, [each](const std::string& v) { each->push_back(v); });
      added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->trigger_on_parse();  // it forgets what came before
    } else added = app.add_option_function<std::string>(option.names, one);
    if (option.repeats == Repeats::lists) added->allow_extra_args(false);  // the next word is an input
    added->check(CLI::Validator([&option](const std::string& value) { return wrong_value(option, value); }, "", ""));
    places_.push_back({command, &option, added->required(option.required), nullptr, each});
  }

  /// The command that was parsed, or "".
  [[nodiscard]] std::string asked() const {
    for (const auto& [name, app] : commands_)
      if (app->parsed()) return name;
    return "";
  }

  /// The names of the options that may be meant.
  [[nodiscard]] std::vector<std::string> known_names() const {
    std::vector<std::string> names = {"-h", "--help"};
    const std::string command = asked().empty() ? before_ : asked();
    if (command.empty()) names.insert(names.end(), {"-V", "--version"});
    for (const Place& place : places_) {
      if (place.command != command || place.option->is_input()) continue;
      for (const std::string& name : place.parsed->get_snames()) names.push_back('-' + name);
      for (const std::string& name : place.parsed->get_lnames()) names.push_back("--" + name);
    }
    return names;
  }

  /// The first option that is unknown, as it was typed, or "".
  [[nodiscard]] std::string unknown_option() const {
    for (const std::string& word : app_.remaining(true))
      if (word.starts_with('-') && word != "--") return word.substr(0, word.find('='));
    return "";
  }

  /// What may be meant by an option that is unknown, or "".
  [[nodiscard]] std::string suggestion() const {
    const std::vector<std::string> names = known_names();
    const std::string typed = unknown_option();
    if (std::ranges::find(names, typed) != names.end()) return fmt::format("; {} stands behind the command", typed);
    return typed.empty() ? "" : did_you_mean(typed, names);
  }

  /// CLI11's sentence, or a plainer one.
  [[nodiscard]] std::string sentence(const CLI::ParseError& error) const {
    const bool of_a_check = dynamic_cast<const CLI::ValidationError*>(&error) != nullptr;
    const std::string text = kernels::printable(error.what(), of_a_check ? longest_list : longest_sentence);
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return text + suggestion();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && !unknown_option().empty())  // misspelt, perhaps
      return fmt::format("{}, and {} is not expected{}", text, kernels::shown(unknown_option()), suggestion());
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return text;
    return text.substr(0, text.find(':')) + ": expected one value, once";
  }

  std::string before_;
  std::span<const Option> table_;
  CLI::App app_;
  std::vector<std::pair<std::string, CLI::App*>> commands_;
  std::vector<Place> places_;
  std::deque<bool> flags_;
  std::deque<std::string> texts_;
  std::deque<std::vector<std::string>> lists_;
};

}  // namespace

bool Given::has(std::string_view name) const {
  const auto found = std::ranges::find(options, name, &GivenOption::name);
  return found != options.end() && !found->values.empty();
}

std::optional<std::string> Given::value(std::string_view name) const {
  const auto found = std::ranges::find(options, name, &GivenOption::name);
  return found == options.end() || found->values.empty() ? std::nullopt : std::optional(found->values.front());
}

std::vector<std::string> Given::words(std::string_view name) const {
  std::vector<std::string> result;
  const auto found = std::ranges::find(options, name, &GivenOption::name);
  if (found == options.end()) return result;
  for (const std::string& value : found->values)
    if (found->option->repeats == Repeats::lists) std::ranges::move(words_of(value), std::back_inserter(result));
    else result.push_back(value);
  return result;
}

std::vector<std::string> Given::inputs() const {
  std::vector<std::string> result;
  for (const GivenOption& option : options)
    if (option.option->is_input()) result.insert(result.end(), option.values.begin(), option.values.end());
  return result;
}

std::string missing_value(std::span<const std::string> words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word.starts_with("--") && word.find('=') == word.size() - 1) return kernels::shown(word) + " lacks its value";
  }
  return "";
}

std::string empty_value(const Given& given) {
  for (const GivenOption& option : given.options)
    if (!option.option->is_input() && std::ranges::find(option.values, "") != option.values.end())
      return option.name + " expects a value, found nothing";
  return "";
}

Given read_words(const std::string& before, std::span<const Option> table, const std::vector<std::string>& words) {
  return Parser(before, table).read(words);
}

}  // namespace fathom::cli
