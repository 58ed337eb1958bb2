// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the words of a command line. No other file uses CLI11, whose parser is made from the table.
#include "cli/args/arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <deque>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include "cli/args/help.hpp"
#include "cli/io/output.hpp"
#include "kernels/messages.hpp"
#include "reference/files/robot.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/golden/shards/plan.hpp"

namespace fathom::cli {

extern const char* const built_commit;  ///< "" outside a checkout; CMake writes it into a source file of its own

namespace {

// ---- words that name no command ----

/// Returns whether the word names bodies or cases.
bool is_input(const std::string& word) {
  std::error_code fault;
  return word == "-" || is_mesh_name(word) || is_cases_name(word) || files::is_shape_text(word) ||
         files::is_robot_text(word) || std::filesystem::is_regular_file(word, fault);
}

/// Returns the command line that is probably meant by inputs without a command, as "; did you mean
/// 'fathom depth a.obj b.obj'?", or "".
std::string line_with_command(const std::vector<std::string>& words) {
  std::vector<std::string> inputs;
  std::copy_if(words.begin(), words.end(), std::back_inserter(inputs), is_input);
  if (inputs.empty()) return "";
  const bool one_body = inputs.size() == 1 &&
                        (is_mesh_name(inputs[0]) || files::is_shape_text(inputs[0]) || files::is_robot_text(inputs[0]));
  return fmt::format("; did you mean: fathom {} {}", one_body ? "width" : "depth", shell_line(words));
}

/// Returns a sentence if the first word is no command, or "".
std::string wrong_command(const std::vector<std::string>& words) {
  const std::string& command = words[0];
  const std::vector<std::string> names = command_names();
  if (command.starts_with('-') || std::ranges::find(names, command) != names.end()) return "";
  if (const std::string line = is_input(command) ? line_with_command(words) : ""; !line.empty())
    return fmt::format("expected a command, found the input {}{}", kernels::shown(command), line);
  return fmt::format("unknown command {} (expected {}){}", kernels::shown(command), fmt::join(names, ", "),
                     did_you_mean(command, names));
}

Arguments no_command() {
  return refusal(fmt::format("expected a command: {}\nFor example: {}", fmt::join(command_names(), ", "),
                             general_help.examples[0].line),
                 "");
}

std::string version_text() {
  const std::string commit = *built_commit ? fmt::format("commit {}\n", built_commit) : "";
  return fmt::format("fathom {}\n{}golden data {}\nlicence GPL-3.0-or-later", FATHOM_VERSION, commit,
                     golden::data_version);
}

// ---- the words of a command ----

constexpr std::size_t longest_sentence = 200;
constexpr std::size_t longest_list =
    4000;  // our own checks list the known words, and a readable part of the text that was typed

std::string wrong_word(const std::string& value, const std::vector<std::string>& words) {
  if (std::ranges::find(words, value) != words.end()) return "";
  const std::string shown = value.empty() ? "the empty value" : kernels::shown(value);
  return fmt::format("{} is unknown (expected {}){}", shown, fmt::join(words, ", "), did_you_mean(value, words));
}

/// Returns what is wrong with a value of the option, or "".
std::string wrong_value(const Option& option, const std::string& value) {
  if (option.values.wrong) return option.values.wrong(value);
  if (option.values.words.empty()) return "";
  const std::vector<std::string> words =
      option.repeats == Repeats::lists ? words_of(value) : std::vector<std::string>{value};
  for (const std::string& word : words)
    if (std::string fault = wrong_word(word, option.values.words); !fault.empty()) return fault;
  return "";
}

/// The parser of one command line, with the variables that receive the values.
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

  Arguments read(const std::vector<std::string>& words) {
    try {
      app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::CallForHelp&) {
      return {std::nullopt, help_text(page_of(command(), table_), help_columns(STDOUT_FILENO)), fine};
    } catch (const CLI::CallForVersion&) {
      return {std::nullopt, version_text(), fine};
    } catch (const CLI::ParseError& error) {
      return refusal(sentence(error) + (command().empty() ? line_with_command(words) : ""), command());
    }
    Given given;
    given.command = command();
    for (const Place& place : places_)
      if (place.command == given.command)
        given.options.push_back({place.option, place.parsed->get_name(), place.values()});
    return {std::move(given), "", fine};
  }

 private:
  /// An option of a command, and where the parser puts its values.
  struct Place {
    std::string command;
    const Option* option;
    CLI::Option* parsed;
    const bool* flag = nullptr;                           ///< its value, if it is a flag
    const std::vector<std::string>* values_of = nullptr;  ///< its values, if it may be given several times

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
    // Values are passed to a function: for a vector, CLI11 would take a file called "[x]" for a
    // list.
    const auto one = [](const std::string&) {};
    std::vector<std::string>* each = nullptr;
    const auto several = [](const std::vector<std::string>&) {};
    CLI::Option* added = nullptr;
    if (option.repeats == Repeats::lists || (option.is_input() && option.repeats == Repeats::each))
      added = app.add_option_function<std::vector<std::string>>(option.names, several);
    else if (option.repeats == Repeats::each) {
      each = &lists_.emplace_back();
      added = app.add_option_function<std::string>(option.names, [each](const std::string& v) { each->push_back(v); });
      added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->trigger_on_parse();  // CLI11 drops earlier values
    } else added = app.add_option_function<std::string>(option.names, one);
    if (option.repeats == Repeats::lists) added->allow_extra_args(false);  // the next word is an input
    added->check(CLI::Validator([&option](const std::string& value) { return wrong_value(option, value); }, "", ""));
    places_.push_back({command, &option, added->required(option.required), nullptr, each});
  }

  /// Returns the command that was parsed; if there was none, the words before it.
  [[nodiscard]] std::string command() const {
    for (const auto& [name, app] : commands_)
      if (app->parsed()) return name;
    return before_;
  }

  /// Returns the names of all options that the command has.
  [[nodiscard]] std::vector<std::string> known_names() const {
    std::vector<std::string> names = {"-h", "--help"};
    if (command().empty()) names.insert(names.end(), {"-V", "--version"});
    for (const Place& place : places_) {
      if (place.command != command() || place.option->is_input()) continue;
      for (const std::string& name : place.parsed->get_snames()) names.push_back('-' + name);
      for (const std::string& name : place.parsed->get_lnames()) names.push_back("--" + name);
    }
    return names;
  }

  /// Returns the first unknown option, as it was typed, or "".
  [[nodiscard]] std::string unknown_option() const {
    for (const std::string& word : app_.remaining(true))
      if (word.starts_with('-') && word != "--") return word.substr(0, word.find('='));
    return "";
  }

  /// Returns a suggestion for the unknown option, or "".
  [[nodiscard]] std::string suggestion() const {
    const std::vector<std::string> names = known_names();
    const std::string typed = unknown_option();
    if (std::ranges::find(names, typed) != names.end()) return fmt::format("; {} stands behind the command", typed);
    return typed.empty() ? "" : did_you_mean(typed, names);
  }

  /// Returns CLI11's sentence on the error, or a plainer one.
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

/// Returns what is wrong with a word like "--name=", for which CLI11 would take the next word as
/// its value, or "". Call it before parsing.
std::string missing_value(std::span<const std::string> words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word.starts_with("--") && word.find('=') == word.size() - 1) return kernels::shown(word) + " lacks its value";
  }
  return "";
}

/// Returns what is wrong if an option has an empty value, which would count as not given, or "".
std::string empty_value(const Given& given) {
  for (const GivenOption& option : given.options)
    if (!option.option->is_input() && std::ranges::find(option.values, "") != option.values.end())
      return option.name + " expects a value, found nothing";
  return "";
}

}  // namespace

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

std::optional<Motion> GivenTwists::in(unsigned dimension) const {
  const auto twist = [&](const std::optional<std::string>& text, const char* option) {
    if (!text) return Twist();
    const std::optional<Twist> twist = typed_twist(*text, dimension);
    const char* const expected =
        dimension == 2 ? "three numbers VX,VY,W of bodies of the plane" : "six numbers of bodies of space";
    return twist ? *twist
                 : throw InputError(option, 0, fmt::format("expected {}, found {}", expected, kernels::shown(*text)));
  };
  if (!*this) return std::nullopt;
  return Motion{twist(of_a, "--twist"), twist(of_b, "--twist-b")};
}

ExitCode said(const Arguments& arguments) {
  arguments.code == fine ? print(arguments.text) : talk(arguments.text);
  return arguments.code;
}

Arguments refusal(const std::string& sentence, const std::string& command) {
  return {std::nullopt, fmt::format("{}\nTry: fathom {}--help", sentence, command.empty() ? "" : command + " "),
          bad_input};
}

Arguments read_words(const std::string& before, std::span<const Option> table, const std::vector<std::string>& words) {
  if (const std::string fault = missing_value(words); !fault.empty()) return refusal(fault, before);
  return Parser(before, table).read(words);
}

Arguments parse_arguments(const std::vector<std::string>& words) {
  if (words.empty()) return no_command();
  const std::string line = "fathom " + shell_line(words);
  if (parses_itself(words[0])) return {Given{words[0], {}, {words.begin() + 1, words.end()}, line}, "", fine};
  // `certify diff` has a word where `certify` alone has a stream of cases.
  const bool compares = words.size() > 1 && words[0] == "certify" && words[1] == "diff";
  if (const std::string fault = wrong_command(words); !fault.empty()) return refusal(fault, "");
  Arguments arguments = compares ? read_words("certify diff", common_options(), {words.begin() + 2, words.end()})
                                 : read_words("", common_options(), words);
  if (!arguments.given) return arguments;
  Given& given = *arguments.given;
  if (given.command.empty()) return no_command();
  if (const std::string fault = empty_value(given); !fault.empty()) return refusal(fault, given.command);
  given.command_line = line;
  if (const std::string fault = wrong_together(given); !fault.empty()) return refusal(fault, given.command);
  return arguments;
}

}  // namespace fathom::cli
