// SPDX-License-Identifier: GPL-3.0-or-later
// The reports of a run: as text, as a page, for systems that run tests; and the difference of two
// runs.                                                                       [docs/certify.md]
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/files.hpp"
#include "fathom/judge.hpp"
#include "kernels/messages.hpp"
#include "kernels/vector.hpp"
#include "verify/harness/journal.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/tally.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {

// ---- the texts that all reports share: ids and foreign texts made printable ----

using kernels::counted;
using picture::ascii;
using picture::markup;

/// The most characters of an id that a line shows.
inline constexpr std::size_t longest_id = 60;

/// Returns the id, with the symmetry of a variant: "id ~swap".
std::string shown_id(std::string_view id, std::string_view variant);

// ---- a subject, its outcomes and their numbers, the same in every report ----

/// Returns "binary64"; "points binary32, answers binary64".
std::string precision_text(const NumberFormat& format);
/// Returns "libccd-epa 2.1 (libccd, binary64)", with any bytes that the subject sent.
std::string title(const SubjectInfo& subject);
/// Returns "bodies that touch are either; the depth is positive; A moves; directions have length
/// 1".
std::string conventions_text(const Conventions& conventions);
/// Returns the body that a claimed direction moves: "A" or "B".
const char* moving_body(const Conventions& conventions);
/// Returns "epa_tolerance = 1e-4", sorted by name.
std::vector<std::string> settings_text(const SubjectInfo& subject);
/// Returns "0.01 of every body"; "0.01 of vertices", one for each name.
std::vector<std::string> rounding_text(const SubjectInfo& subject);
/// Returns "its own radii are larger than the bodies in 63 of 63 cases"; empty if they never are.
std::string dwarfed_text(const TallyRow& all);
/// Returns "relative 1/1000, absolute 1/1000000 of the extent, 4 ulp; the largest counts; policy
/// within=5%"; omits a policy that is the subject's own.
std::string tolerance_text(const Tolerance& tolerance);
/// Returns "every case by a power of two: its longest side is less than 64, and at least half of
/// that".
std::string fit_text(const mpq_class& fit);

/// Returns one sentence on an outcome: that of the judge, and the harness's observation; without
/// either, the name of its verdict.
std::string sentence_of(const Outcome& outcome);

/// Returns three digits, "-4.44e-16"; "0" for an exact zero.
std::string error_text(double error);
/// Returns "10000 cases: 9000 pass, 990 fail, 10 unsupported; 2 unattributed"; omits the last two
/// numbers if they are 0.
std::string totals_text(std::size_t total, std::size_t passes, std::size_t failures, std::size_t unattributed = 0);

/// Returns "median 0 above the depth, worst 0.414, of 12 directions"; "3 longer translations pass
/// by the policy".
std::vector<std::string> excess_entries(const TallyRow& row);
/// Returns the parts that are neither empty nor the whole, with their labels: "solid",
/// "metre-sized", "both".
std::vector<Tally::Line> shown_parts(const Tally& tally);

/// Returns the classes of passes: "correctly rounded: 61", "16 uR: 4".
std::vector<std::string> accuracy_entries(const TallyRow& row);

// ---- the table at the end of a run: the verdicts of each family, and the errors ----

class Summary {
 public:
  void add(const Outcome& outcome) { tally_.add(outcome); }
  void add(const Unattributed& unattributed) { ++unattributed_[unattributed.detail]; }

  /// Returns several lines, the last with its newline: the subject with its conventions and
  /// settings; a row for each family that fails and one for the others, or for each with
  /// `all_rows`; the ids of the worst failures of each verdict in `outcomes`; `where` to find more;
  /// coverage; explanations of words; totals. At most `columns` wide, or 40 if that is more, except
  /// for the numbers of a column and for longer words. Pure ASCII for any names; only the verdicts
  /// that occur have a column.
  [[nodiscard]] std::string table(const SubjectInfo& subject, std::span<const Outcome> outcomes = {},
                                  const std::vector<std::string>& where = {}, std::size_t columns = 140,
                                  bool all_rows = false) const;
  [[nodiscard]] std::size_t failures() const { return tally_.all().failures(); }
  [[nodiscard]] std::size_t passes() const { return tally_.all().passes(); }
  [[nodiscard]] std::size_t total() const { return tally_.all().total; }
  /// Returns the number of failures that no case caused.
  [[nodiscard]] std::size_t unattributed() const { return sum(unattributed_); }
  [[nodiscard]] const UnattributedCounts& unattributed_counts() const { return unattributed_; }
  [[nodiscard]] const Tally& tally() const { return tally_; }

  std::optional<mpq_class> fit;  ///< the size that cases were brought to

 private:
  Tally tally_;
  UnattributedCounts unattributed_;
};

// ---- a run as one self-contained page: without scripts, fonts or pictures from elsewhere. It has
// the table, error histograms, and for each failure the pair, the claim and the truth ----

/// A failure that is shown in full.
struct HtmlFailure {
  Outcome outcome;
  Case seen;                     ///< its points, as they were put to the subject
  std::string certificate_name;  ///< the file that proves the truth; empty if there is none
};

inline constexpr std::size_t most_shown_failures = 200;
/// The most cases that have a row in the table.
inline constexpr std::size_t most_listed = 5000;

/// Returns the indices of failures to show in full, worst first: of each verdict and of each family
/// at least one, within `most`, then the largest errors.
std::vector<std::size_t> failures_to_show(std::span<const Outcome> outcomes, std::size_t most = most_shown_failures);

/// Returns the page. `outcomes` are all of the run; it shows those of `failures` in full, and the
/// other failures in a table. Solves each pair of `failures` again for its picture. Well-formed for
/// any ids and details.
std::string html_page(const SubjectInfo& subject, std::span<const Outcome> outcomes,
                      std::span<const HtmlFailure> failures, const Tolerance& tolerance, const RunInfo& from = {});

// ---- the parts of the page: each consists of whole elements, and escapes foreign texts ----

/// Returns the rank of a verdict on the page: wrong answers by rank, then missing answers, then
/// declined cases, then passes.
std::size_t place_on_page(Verdict verdict);

/// Returns the shares of a bar: passes, then wrong answers, then missing answers, then declined
/// cases. Verdicts in `shown` link to their sections.
std::vector<picture::Share> verdict_shares(const TallyRow& all, const std::set<Verdict>& shown);

/// Returns all about one failure. `anchor` is its id in the page.
std::string failure_article(const SubjectInfo& subject, const HtmlFailure& failure, const std::string& anchor);

/// A failure of the page, and its id there.
struct Anchored {
  const HtmlFailure* failure;
  std::string anchor;
};

/// Returns the translation of A that a reply claims, to within a few roundings, for directions of
/// any length. Returns nullopt if the reply has no direction, or a number of it is not finite.
std::optional<Point> claimed_translation(const Reply& reply, const Conventions& conventions);

// ---- the list of known failures. It is strict: a run agrees with it if and only if the listed
// cases fail, with the listed verdicts, and no others. It has one line for each failure:
//
//     <verdict> <id>[~<variant>]   # why
//
// Blank lines and lines that begin with '#' are comments, and so is everything after a '#' that a
// blank precedes. In an id, blanks, control characters, '%' and '~' are written as "%" and two
// hexadecimal digits, as in URLs, and so is a '#' that begins it; an empty id is "%". ----

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

// ---- two reports, of two versions of one subject or of two subjects: which cases changed their
// verdict, and whose error changed most ----

/// A case of both reports whose answers differ.
struct Change {
  std::string id, variant;
  Verdict old_verdict, new_verdict;
  /// The claimed depth less the true one in parts of R, the largest coordinate; nullopt without a
  /// claimed depth.
  std::optional<double> old_error, new_error;
  /// Whether the two subjects got different points: in another precision, or because the case was
  /// changed.
  bool other_points = false;

  /// Returns by how much the magnitude of one error exceeds that of the other; a missing or
  /// non-finite error counts as 0.
  [[nodiscard]] double error_change() const;
};

/// A field whose values in the two headers differ; empty if it is missing.
struct HeaderDifference {
  std::string field, old_value, new_value;
};

struct ReportDiff {
  std::vector<HeaderDifference> header;
  TallyRow old_row, new_row;  ///< of the cases of both
  std::size_t only_old = 0, only_new = 0, other_points = 0;
  // Each by error_change(), largest first, then by id:
  std::vector<Change> newly_failing;  ///< fails in the new report, passed or was declined in the old one
  std::vector<Change> newly_passing;  ///< passes in the new report, and did not in the old one
  std::vector<Change> otherwise;      ///< has another verdict, with neither change
  std::vector<Change> errors;         ///< has the same verdict and another error; at most `most_errors`
};

ReportDiff diff(const ReportFile& before, const ReportFile& after);

/// Returns the sizes of the three lists with their names: "2 newly failing, 0 newly passing, 1 with
/// another verdict; 63 in both".
std::string totals_text(const ReportDiff& diff);

/// Returns lines of text, each list of at most `most` entries. Pure ASCII for any ids.
std::vector<std::string> diff_text(const ReportFile& before, const ReportFile& after, const ReportDiff& diff,
                                   std::size_t most = 20);

/// Returns one line of schema fathom/diff/1, without the newline.
std::string diff_json(const ReportFile& before, const ReportFile& after, const ReportDiff& diff);

/// Returns a self-contained page.
std::string diff_page(const ReportFile& before, const ReportFile& after, const ReportDiff& diff,
                      const std::string& version, const std::string& command);

}  // namespace fathom::harness
