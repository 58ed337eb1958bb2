// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a command line, read by the table of options: what was given, or the sentence on
// what is wrong with it. Whether options go together is the commands' to say.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/args/options.hpp"

namespace fathom::cli {

/// What was given of one option, or of the places for inputs.
struct GivenOption {
  const Option* option;
  std::string name;                 ///< the first long one: "--output"; of an input "first"
  std::vector<std::string> values;  ///< as typed; of a flag "true"
};

struct Given {
  enum class Kind { request, help, version, refused };
  Kind kind = Kind::request;
  std::string command;               ///< "depth", "golden verify"; if there was none, what the words stand behind
  std::string fault;                 ///< what is wrong, if it is refused
  std::vector<GivenOption> options;  ///< all that the command has, in the order of the table

  /// The command has the option, and it was given.
  [[nodiscard]] bool has(std::string_view name) const;
  /// The first value, or nullopt. `name`: with its dashes.
  [[nodiscard]] std::optional<std::string> value(std::string_view name) const;
  /// The first value, or "".
  [[nodiscard]] std::string text(std::string_view name) const { return value(name).value_or(""); }
  /// All values, lists taken apart.
  [[nodiscard]] std::vector<std::string> words(std::string_view name) const;
  /// A flag that is set.
  [[nodiscard]] bool flag(std::string_view name) const { return text(name) == "true"; }
  [[nodiscard]] std::vector<std::string> inputs() const;
};

/// Reads the words behind "fathom" and `before`, which is "", "golden" or "certify diff". Never
/// throws, whatever the user typed.
Given read_words(const std::string& before, std::span<const Option> table, const std::vector<std::string>& words);

/// Returns what is wrong with a word like "--name=", whose value would be taken from the next word,
/// or "". To be asked first.
std::string missing_value(std::span<const std::string> words);

/// Returns what is wrong if an option has an empty value, which would count as not given, or "".
std::string empty_value(const Given& given);

/// Says which output of the command would destroy an input or another output, standard streams
/// included; or a file that is named like a mesh or like cases, as where the name of an output was
/// forgotten; or "". Files are the same by what the file system says, however they are named;
/// devices and pipes are passed over. `stream`: the command answers a stream of cases.
std::string wrong_files(const Given& given, bool stream);

}  // namespace fathom::cli
