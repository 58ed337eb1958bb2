// SPDX-License-Identifier: Apache-2.0
// The program behind its command line: all inputs one after another, one line per certificate.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"

namespace fathom_check {

struct Input {
  std::string path;         ///< "-" for standard input
  bool is_results = false;  ///< JSON Lines, each with a certificate
};

struct Options {
  std::vector<Input> inputs;
  std::optional<std::string> cases;  ///< to compare points with
  bool width = false;                ///< the certificates are about the width of a body: b repeats a
  bool echo = false;
};

/// Prints verdicts to `out`, complaints about the case file to `err`. The exit code.
int run(const Options& options, std::istream& standard_input, std::ostream& out, std::ostream& err);

}  // namespace fathom_check
