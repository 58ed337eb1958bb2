// SPDX-License-Identifier: GPL-3.0-or-later
// The texts that all reports share: ids and foreign texts made printable, a subject and its
// numbers, and the table at the end of a run.
//                                                                                 [docs/certify.md]
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/messages.hpp"
#include "verify/harness/outcome.hpp"
#include "verify/harness/tally.hpp"
#include "view/picture/markup.hpp"

namespace fathom::harness {

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

}  // namespace fathom::harness
