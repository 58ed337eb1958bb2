// SPDX-License-Identifier: GPL-3.0-or-later
// The options of all commands, as one table: whose they are, how they are called, what they mean,
// which values they take. The parser, help, manual pages and the completion of shells are made of
// it. Then what was given of them on a command line, of which each command fills a struct of its
// own; or help, or a sentence on what is wrong.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/values.hpp"
#include "cli/io/output.hpp"

namespace fathom::cli {

/// What the value of an option names. wrong_files sees to it that nothing that is
/// written is read, or written otherwise.
enum class FileUse {
  none,
  read,
  read_list,     ///< a file that write_list may bring up to date
  journal,       ///< a file that grows: its writer never replaces it
  written,       ///< a file
  written_list,  ///< a file that may be the one that read_list names
  placed,        ///< a file; of a stream, a folder for a file of each case, which may be that of another option
  folder,        ///< a folder for files of names that the command chooses
};

/// How often an option may be given.
enum class Repeats {
  never,
  each,   ///< each time with one value more
  lists,  ///< likewise, and a value is a list with commas
};

/// Which values are good.
struct Values {
  /// a sentence, or ""; null: any text, or one of `words` if there are some
  std::string (*wrong)(const std::string& value) = nullptr;
  std::vector<std::string> words = {};  ///< that help and completion show
};

/// An option; or, if its name has no dash, a place for an input.
struct Option {
  std::string commands;  ///< those that have it, with commas between them: "depth,golden verify"
  std::string names;     ///< with commas between them: "-o,--output"
  /// "NAME"; "" of a flag; "[=LIST]" of a flag whose value, here in braces behind the name, may be
  /// another
  std::string value;
  std::string meaning;  ///< white space is no more than that
  Values values = {};
  FileUse use = FileUse::none;
  Repeats repeats = Repeats::never;
  bool required = false;

  [[nodiscard]] bool is_flag() const { return value.empty() || value.front() == '['; }
  [[nodiscard]] bool is_input() const { return names.front() != '-'; }
  [[nodiscard]] bool belongs_to(std::string_view command) const;
};

/// The options of the commands that bodies, cases, reports and certificates are for, and of help.
/// The options of one command are in the order of its help.
std::span<const Option> common_options();

/// The options of `golden` and its tasks: golden_options.cpp, which fathom-depth has not.
std::span<const Option> golden_options();

// The words of a command line, read by the table of options: what was given, or the sentence on
// what is wrong with it. Whether options go together is the commands' to say.

/// What was given of one option, or of the places for inputs.
struct GivenOption {
  const Option* option;
  std::string name;                 ///< the first long one: "--output"; of an input "first"
  std::vector<std::string> values;  ///< as typed, and good by the table; of a flag "true"
};

/// A command line that was read.
struct Given {
  std::string command;               ///< "depth", "golden verify"
  std::vector<GivenOption> options;  ///< all that the command has, in the order of the table
  std::vector<std::string> rest;     ///< the words behind a command that reads them itself
  std::string command_line;          ///< "fathom depth a.off b.off", quoted for a shell

  /// The command has the option, and it was given.
  [[nodiscard]] bool has(std::string_view name) const { return value(name).has_value(); }
  /// The first value, or nullopt. `name`: with its dashes.
  [[nodiscard]] std::optional<std::string> value(std::string_view name) const;
  /// The first value, or "".
  [[nodiscard]] std::string text(std::string_view name) const { return value(name).value_or(""); }
  /// All values, lists taken apart.
  [[nodiscard]] std::vector<std::string> words(std::string_view name) const;
  /// A flag that is set.
  [[nodiscard]] bool flag(std::string_view name) const { return text(name) == "true"; }
  [[nodiscard]] std::vector<std::string> inputs() const;
  /// The first value as an integer, or as a number, or nullopt.
  template <class Integer>
  [[nodiscard]] std::optional<Integer> integer(std::string_view name) const;
  [[nodiscard]] std::optional<mpq_class> number(std::string_view name) const { return typed_number(text(name)); }
  /// What --twist and --twist-b say; nullopt without either.
  [[nodiscard]] std::optional<Motion> motion() const;
};

template <class Integer>
std::optional<Integer> Given::integer(std::string_view name) const {
  const std::optional<std::string> text = value(name);
  return text ? std::optional(static_cast<Integer>(typed_integer(*text).value())) : std::nullopt;
}

/// Either what is to be done, or a text for the user and the exit code that goes with it: help and
/// version (fine, for standard output), or a refusal (bad_input, for standard error).
struct Arguments {
  std::optional<Given> given;
  std::string text;
  ExitCode code = fine;
};

/// Prints the text where it belongs, and returns the code.
ExitCode said(const Arguments& arguments);

/// Reads the words behind "fathom", and refuses options that do not go together. Of commands that
/// read their words themselves only the first is read. Never throws, whatever the user typed.
Arguments parse_arguments(const std::vector<std::string>& words);

/// Reads the words behind "fathom" and `before`, which is "", "golden" or "certify diff": by the
/// table alone. Never throws.
Arguments read_words(const std::string& before, std::span<const Option> table, const std::vector<std::string>& words);

/// The refusal of a command's words, with the line that prints help.
Arguments refusal(const std::string& sentence, const std::string& command);

/// Says what does not go together of what was given, files included, or "".
std::string wrong_together(const Given& given);

/// Says which output of the command would destroy an input or another output, standard streams
/// included; or a file that is named like a mesh or like cases, as where the name of an output was
/// forgotten; or "". Files are the same by what the file system says, however they are named;
/// devices and pipes are passed over. `stream`: the command answers a stream of cases.
std::string wrong_files(const Given& given, bool stream);

}  // namespace fathom::cli
