// SPDX-License-Identifier: Apache-2.0
// The program behind its command line: all inputs one after another, one line per certificate.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "check.hpp"

namespace fathom_check {

/// A second checker: a certificate is accepted only if both accept it.
class SecondChecker {
 public:
  /// Its verdict on one certificate, with the line to print.
  struct Opinion {
    Outcome outcome = Outcome::refused;
    std::string line;
  };

  virtual ~SecondChecker() = default;
  /// A well-formed certificate, not yet checked.
  virtual void hand_over(const Certificate& certificate) = 0;
  /// On the one that was handed over last and has been found right. May throw: then nothing more is checked.
  virtual Opinion opinion(const std::string& name) = 0;
};

struct Input {
  std::string path;         ///< "-" for standard input
  bool is_results = false;  ///< JSON Lines, each with a certificate
};

struct Options {
  std::vector<Input> inputs;
  std::optional<std::string> cases;  ///< to compare points with
  bool width = false;                ///< the certificates are about the width of a body: b repeats a
  bool echo = false;
  SecondChecker* second = nullptr;  ///< may be absent
};

/// Prints verdicts to `out`, complaints about the case file to `err`. Returns the exit code.
int run(const Options& options, std::istream& standard_input, std::ostream& out, std::ostream& err);

}  // namespace fathom_check
