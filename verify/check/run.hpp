// SPDX-License-Identifier: Apache-2.0
// The program behind its command line: all inputs one after another, one line per certificate.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check.hpp"
#include "comparisons.hpp"

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

// The command line of fathom-check, for its own program and for others that offer it as a command.

/// An option of the command line, for help.
struct OptionText {
  std::string_view name, value, meaning;
};
inline constexpr OptionText option_texts[] = {
    {"--case", "CASES",
     "also refuse a certificate whose points are not those of\nyour case (JSON, schema fathom/case/1 "
     "or\nfathom/golden-export/1; of "
     "several cases, the one with\nthe certificate's id)"},
    {"--width", "",
     "also refuse a certificate whose b is not a again: its\ndepth is the width of a; --case then compares a alone"},
    {"--results", "FILE", "JSON Lines, each with a certificate in its field\n\"certificate\""},
    {"--echo", "", "print the bodies and the claim as they were read, in\nlines that begin with c"},
    {"--help", "", "print help"},
};

/// Understands the words behind the program's name, checks, prints to the standard streams.
/// `program` is for messages. Returns the exit code; does not throw. `second`, if given, must
/// accept as well; `workers`, if given, check several certificates at once. Where GMP would abort
/// for lack of memory, the process ends with 2.
int command_line(const std::vector<std::string>& words, const std::string& program, SecondChecker* second = nullptr,
                 Workers* workers = nullptr) noexcept;

}  // namespace fathom_check
