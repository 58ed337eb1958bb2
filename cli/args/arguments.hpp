// SPDX-License-Identifier: GPL-3.0-or-later
// The table of options of all commands: which commands have them, their names, meanings and values.
// The parser, help, manual pages and the completion of shells are made from it. And the result of
// reading a command line: the options that were given, from which each command fills a struct of
// its own; or a text of help; or a sentence on what is wrong.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/values.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {

/// How an option uses the file that it names. wrong_files refuses an output that is also an input,
/// or another output.
enum class FileUse {
  none,
  read,
  read_list,     ///< a file that the one of written_list may replace
  journal,       ///< a file that is only appended to
  written,       ///< a file
  written_list,  ///< a file that may be the one that read_list names
  placed,        ///< a file; for a stream, a folder with a file for each case, which other options may share
  folder,        ///< a folder for files whose names the command chooses
};

/// How often an option may be given.
enum class Repeats {
  never,
  each,   ///< any number of times, with one value each
  lists,  ///< likewise, and each value is a list with commas
};

/// The values that an option accepts.
struct Values {
  /// Returns a sentence on a bad value, or "". Null: any text is good, or one of `words` if there
  /// are some.
  std::string (*wrong)(const std::string& value) = nullptr;
  std::vector<std::string> words = {};  ///< the values that help and completion show
};

/// An option; or, if its name has no dash, a positional input.
struct Option {
  std::string commands;  ///< the commands that have it, with commas between them: "depth,golden verify"
  std::string names;     ///< with commas between them: "-o,--output"
  /// The placeholder: "NAME"; "" of a flag; "[=LIST]" of a flag with an optional value, whose
  /// default stands in braces behind its name.
  std::string value;
  std::string meaning;  ///< help breaks it anew: line ends and spaces are alike
  Values values = {};
  FileUse use = FileUse::none;
  Repeats repeats = Repeats::never;
  bool required = false;

  [[nodiscard]] bool is_flag() const { return value.empty() || value.front() == '['; }
  [[nodiscard]] bool is_input() const { return names.front() != '-'; }
  [[nodiscard]] bool belongs_to(std::string_view command) const;
};

/// The options of commands on bodies, cases, reports and certificates, and of help. Those of one
/// command are in the order of its help.
std::span<const Option> common_options();

/// The options of `golden` and its tasks, from cli/commands/golden.cpp, which is not part of
/// fathom-depth.
std::span<const Option> golden_options();

// The options of a command line, read by the table; or the sentence on what is wrong. The commands
// check whether options go together.

/// The values given for one option, or for the positional inputs.
struct GivenOption {
  const Option* option;
  std::string name;                 ///< the first long name: "--output"; of an input "first"
  std::vector<std::string> values;  ///< as typed; the table accepts them; of a flag "true"
};

/// Motions as they were typed: how many numbers there must be depends on the bodies.
struct GivenTwists {
  std::optional<std::string> of_a = {}, of_b = {};

  explicit operator bool() const { return of_a || of_b; }
  /// Returns the motion, nullopt if there is none. Throws InputError if these are not the numbers
  /// of one in that dimension.
  [[nodiscard]] std::optional<Motion> in(unsigned dimension) const;
};

/// The result of reading a command line.
struct Given {
  std::string command;               ///< "depth", "golden verify"
  std::vector<GivenOption> options;  ///< all options of the command, in the order of the table
  std::vector<std::string> rest;     ///< the words after a command that parses them itself
  std::string command_line;          ///< "fathom depth a.off b.off", quoted for a shell

  /// Returns whether the option was given; false if the command does not have it.
  [[nodiscard]] bool has(std::string_view name) const { return value(name).has_value(); }
  /// Returns the first value, or nullopt. `name`: with its dashes.
  [[nodiscard]] std::optional<std::string> value(std::string_view name) const;
  /// Returns the first value, or "".
  [[nodiscard]] std::string text(std::string_view name) const { return value(name).value_or(""); }
  /// Returns all values, with lists split.
  [[nodiscard]] std::vector<std::string> words(std::string_view name) const;
  /// Returns whether the flag is set.
  [[nodiscard]] bool flag(std::string_view name) const { return text(name) == "true"; }
  [[nodiscard]] std::vector<std::string> inputs() const;
  /// Returns the first value as an integer, or as a number, or nullopt.
  template <class Integer>
  [[nodiscard]] std::optional<Integer> integer(std::string_view name) const;
  [[nodiscard]] std::optional<mpq_class> number(std::string_view name) const { return typed_number(text(name)); }
  /// Returns what was typed with --twist and --twist-b.
  [[nodiscard]] GivenTwists twists() const { return {value("--twist"), value("--twist-b")}; }
};

template <class Integer>
std::optional<Integer> Given::integer(std::string_view name) const {
  const std::optional<std::string> text = value(name);
  return text ? std::optional(static_cast<Integer>(typed_integer(*text).value())) : std::nullopt;
}

/// What to do; or a text for the user with its exit code: help and version (fine, for standard
/// output), or a refusal (bad_input, for standard error).
struct Arguments {
  std::optional<Given> given;
  std::string text;
  ExitCode code = fine;
};

/// Prints the text to the stream of its exit code, and returns the code.
ExitCode said(const Arguments& arguments);

/// Reads the words after "fathom", and refuses options that do not go together. If the command
/// parses its words itself, reads only the first. Never throws, whatever the user typed.
Arguments parse_arguments(const std::vector<std::string>& words);

/// Reads the words after "fathom" and `before`, which is "", "golden" or "certify diff", by the
/// table alone. Never throws.
Arguments read_words(const std::string& before, std::span<const Option> table, const std::vector<std::string>& words);

/// Returns the refusal of a command's words, with the command line that prints help.
Arguments refusal(const std::string& sentence, const std::string& command);

/// Returns a sentence on options and files that do not go together, or "".
std::string wrong_together(const Given& given);

/// Returns a sentence, or "", on an output that would destroy an input or another output, standard
/// streams included; or on an existing mesh or file of cases as output, which is probably an input
/// after an output whose name was forgotten. Two names are the same file if the file system says
/// so; devices and pipes are ignored. `stream`: the command answers a stream of cases.
std::string wrong_files(const Given& given, bool stream);

}  // namespace fathom::cli
