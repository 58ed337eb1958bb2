// SPDX-License-Identifier: GPL-3.0-or-later
// What systems that run tests of others need: the list of known failures, and a run as JUnit XML.
// The list is strict: a run agrees with it exactly when it fails where the list says, as the list
// says, and nowhere else. One line for each failure:
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

/// How one outcome is written in the list, without comment and newline: "too-deep fcl-545". One
/// line, whatever the id holds.
std::string failure_line(const Outcome& outcome);
/// The second word of that line: "fcl-545~swap".
std::string failure_key(const Outcome& outcome);

class ExpectedFailures {
 public:
  /// Throws InputError when the file cannot be read, and on a line that is none of the list, with
  /// its number. An empty list is a list.
  static ExpectedFailures read(const std::string& path);
  /// Reads the list from a text; `name` is for messages.
  static ExpectedFailures parse(const std::string& text, const std::string& name);

  struct Check {
    std::set<std::string> allowed;         ///< the failures that are on the list, as `failure_line` writes them
    std::vector<std::string> surprises;    ///< sentences, for people: where run and list disagree
    std::size_t unlisted = 0;              ///< of them: failures that are not on the list
    std::size_t fixed = 0;                 ///< of them: listed, and pass now
    std::size_t changed = 0;               ///< of them: listed with another verdict than they have now
    std::size_t unmet = 0;                 ///< of them: listed, and no case of the run has that id
    std::set<std::string> fixed_keys;      ///< as `failure_key` writes them, of those that pass now
    std::vector<std::string> unmet_lines;  ///< those that no case met
    [[nodiscard]] bool ok() const { return surprises.empty(); }
  };
  /// Compares with a finished run. Where ids repeat, as many lines must stand in the list as cases
  /// fail.
  [[nodiscard]] Check check(std::span<const Outcome> outcomes) const;
  [[nodiscard]] std::size_t size() const { return entries_.size(); }

  /// Returns the comments of the list, and those of its lines that are in `failing`, as
  /// `failure_line` writes them. Removes these from `failing`.
  [[nodiscard]] std::string renewed(std::multiset<std::string>& failing) const;

 private:
  struct Entry {
    Verdict verdict;
    std::string key;
    std::size_t line;
    [[nodiscard]] std::string text() const;  ///< as `failure_line` writes it
  };
  /// Returns what a line says, or nullopt if it is blank or a comment. Throws InputError.
  static std::optional<Entry> entry_in(std::string_view words, const std::string& name, std::size_t line);
  /// Strikes out the entries and outcomes of one id that agree, and adds what is left to the
  /// result.
  void settle(const std::string& key, const std::vector<Entry>& listed, const std::vector<Verdict>& got,
              Check& result) const;

  std::vector<Entry> entries_;
  std::string name_, text_;
};

/// Returns the list that a run agrees with, under a comment that names the subject; `read` reads it
/// back. Comments of the list `before`, and its lines that are still true, stay as they are; new
/// lines follow, sorted.
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

/// A whole document in UTF-8, well-formed whatever ids, details and replies hold; it depends on its
/// arguments alone. Order: families by name, cases as given. `known` is what
/// ExpectedFailures::check said, and empty without a list; `from` is in the properties.
std::string junit_xml(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                      const ExpectedFailures::Check& known = {}, const RunInfo& from = {});

}  // namespace fathom::harness
