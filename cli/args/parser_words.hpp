// SPDX-License-Identifier: GPL-3.0-or-later
// What CLI11 is asked and told in the same way everywhere: the options of a command, plain sentences, and suggestions.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <vector>

#include "cli/args/help_page.hpp"

namespace fathom::cli {

/// A value that must be one of `words`, which help and completion show.
CLI::Validator one_of(std::vector<std::string> words);

/// The same with a check of its own: the words are for help and completion only.
CLI::Validator one_of(std::vector<std::string> words, std::function<std::string(const std::string&)> check);

/// Returns the options that `app` knows.
std::vector<OptionHelp> options_of(CLI::App& app);

/// Returns CLI11's sentence on what `app` parsed, or a plainer one. `asked`: the command in the words, if there is one, whose options may
/// be meant.
std::string sentence(const CLI::ParseError& error, CLI::App& app, CLI::App* asked = nullptr);

/// Returns what is wrong with a word like "--name=", whose value CLI11 would take from the next word, or "".
std::string missing_value(std::span<const std::string> words);

/// Returns what is wrong if an option of `command` has an empty value, which would count as not given, or "".
std::string empty_value(const CLI::App& command);

}  // namespace fathom::cli
