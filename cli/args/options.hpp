// SPDX-License-Identifier: GPL-3.0-or-later
// The options of all commands, as one table: whose they are, how they are called, what they mean,
// which values they take. The parser, help, manual pages and the completion of shells are made of
// it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom::cli {

/// What the value of an option names. wrong_files (given.hpp) sees to it that nothing that is
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
/// Those of one command are in the order of its help.
std::span<const Option> common_options();

/// The options of `golden` and its tasks.
/// golden_options.cpp
std::span<const Option> golden_options();

}  // namespace fathom::cli
