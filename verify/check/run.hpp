// SPDX-License-Identifier: Apache-2.0
// The program behind its command line: all inputs one after another, one line per certificate.
#pragma once

#include <functional>
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
  /// On the one that was handed over last and has been found right. May throw: then nothing more is
  /// checked.
  virtual Opinion opinion(const std::string& name) = 0;
};

/// One certificate, or one result, on its way through a run.
struct Piece {
  std::function<void()> work;    ///< may be called on any thread, while other pieces are worked on
  std::function<void()> report;  ///< after the work, in the order of the input
};

/// Does the pieces of a run, several at once.
class Workers {
 public:
  virtual ~Workers() = default;
  /// Calls `next` until it returns nothing, one call at a time; calls `work` and then `report` of
  /// each piece. `next` may wait for input: meanwhile every piece that it has returned is reported.
  virtual void run(const std::function<std::optional<Piece>()>& next) = 0;
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
  /// if absent, one piece is done after the other; so they are if there is a second checker
  Workers* workers = nullptr;
};

/// Prints verdicts to `out`, complaints about the case file to `err`. Returns the exit code.
int run(const Options& options, std::istream& standard_input, std::ostream& out, std::ostream& err);

}  // namespace fathom_check
