// SPDX-License-Identifier: GPL-3.0-or-later
// Files for systems that run tests: the list of known failures, and a run as JUnit XML. The list is
// strict: a run agrees with it if and only if the listed cases fail, with the listed verdicts, and
// no others. It has one line for each failure:
//
//     <verdict> <id>[~<variant>]   # why
//
// Blank lines and lines that begin with '#' are comments, and so is everything after a '#' that a
// blank precedes. In an id, blanks, control characters, '%' and '~' are written as "%" and two
// hexadecimal digits, as in URLs, and so is a '#' that begins it; an empty id is "%".
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/harness/outcome.hpp"
#include "verify/harness/tally.hpp"

namespace fathom::harness {

/// Returns the line of an outcome in the list, without comment and newline: "too-deep fcl-545". One
/// line for any id.
std::string failure_line(const Outcome& outcome);
/// Returns the second word of that line: "fcl-545~swap".
std::string failure_key(const Outcome& outcome);

class ExpectedFailures {
 public:
  /// Throws InputError if the file cannot be read, or with its number for a line that does not
  /// belong to a list. The list may be empty.
  static ExpectedFailures read(const std::string& path);
  /// Reads the list from a text; `name` is for messages.
  static ExpectedFailures parse(const std::string& text, const std::string& name);

  struct Check {
    std::set<std::string> allowed;         ///< the failures that are on the list, as `failure_line` writes them
    std::vector<std::string> surprises;    ///< sentences on differences between run and list
    std::size_t unlisted = 0;              ///< number of failures that are not on the list
    std::size_t fixed = 0;                 ///< number of listed cases that pass now
    std::size_t changed = 0;               ///< number of listed cases with another verdict now
    std::size_t unmet = 0;                 ///< number of lines whose id no case of the run has
    std::set<std::string> fixed_keys;      ///< of cases that pass now, as `failure_key` writes them
    std::vector<std::string> unmet_lines;  ///< lines whose id no case has
    [[nodiscard]] bool ok() const { return surprises.empty(); }
  };
  /// Compares with a finished run. If ids repeat, the list must have as many lines as cases that
  /// fail.
  [[nodiscard]] Check check(std::span<const Outcome> outcomes) const;
  [[nodiscard]] std::size_t size() const { return entries_.size(); }

  /// Returns the comments of the list, and those of its lines that are in `failing`, as
  /// `failure_line` writes them. Removes these lines from `failing`.
  [[nodiscard]] std::string renewed(std::multiset<std::string>& failing) const;

 private:
  struct Entry {
    Verdict verdict;
    std::string key;
    std::size_t line;
    [[nodiscard]] std::string text() const;  ///< as `failure_line` writes it
  };
  /// Returns the entry of a line, or nullopt for a blank line or a comment. Throws InputError.
  static std::optional<Entry> entry_in(std::string_view words, const std::string& name, std::size_t line);
  /// Matches the entries and outcomes of one id that agree, and adds the others to the result.
  void settle(const std::string& key, const std::vector<Entry>& listed, const std::vector<Verdict>& got,
              Check& result) const;

  std::vector<Entry> entries_;
  std::string name_, text_;
};

/// Returns the list that agrees with a run, under a comment that names the subject; `read` reads it
/// back. Keeps the comments of the list `before` and its lines that still apply; new lines follow,
/// sorted.
std::string expected_failures_text(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                                   const ExpectedFailures& before = {});

// ---- a run as JUnit XML, for the systems that run tests of others: a suite for each family, a
// test case for each case ----
//
//   pass, touching-by-convention                test case without a child
//   unsupported                                 <skipped>
//   crash, time-out, silent, garbage, failed    <error>
//   any other failure                           <failure>, its type the verdict
//   a failure that the list of known ones has   <skipped>
//   a listed failure that passes now            <failure type="unexpected-pass">
//   a listed failure that no case met           <failure type="not-met"> in a suite "known
//   failures"

/// Returns a document in UTF-8, well-formed for any ids, details and replies; it depends on the
/// arguments alone. Order: families by name, cases as given. `known` is the result of
/// ExpectedFailures::check, and empty without a list; `from` is written into the properties.
std::string junit_xml(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                      const ExpectedFailures::Check& known = {}, const RunInfo& from = {});

}  // namespace fathom::harness
