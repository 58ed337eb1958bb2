// SPDX-License-Identifier: GPL-3.0-or-later
// The parser of the command line, with the values that it fills in.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/args/request.hpp"

namespace fathom::cli {

/// The values of the options, before it is checked whether they go together.
struct Texts {
  std::string method = "auto", closest_lines;
  bool exact_decimals = false;
  std::string wrong_cases;    ///< what does not go together in `cases`
  std::string wrong_picture;  ///< what does not go together in a request for a curve or a chart
  std::string wrong_files;    ///< which output would destroy what
};

struct Parser {
  Parser();
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  /// The command that was parsed, or nullptr.
  [[nodiscard]] CLI::App* asked() const;

  Request request;
  Texts texts;
  CLI::App app{"", "fathom"};
  std::vector<CLI::App*> commands;  ///< in the order of `Command`
};

}  // namespace fathom::cli
