// SPDX-License-Identifier: GPL-3.0-or-later
// What all reports say, in words: ids and texts of others made fit to be shown, a subject and its
// numbers, and the table that ends a run.
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

/// The id, and the symmetry if there is one: "id ~swap".
std::string shown_id(std::string_view id, std::string_view variant);

// ---- a subject, its outcomes and their numbers, the same in every report ----

/// "binary64"; "points binary32, answers binary64".
std::string precision_text(const NumberFormat& format);
/// "libccd-epa 2.1 (libccd, binary64)". Any bytes that the subject gave.
std::string title(const SubjectInfo& subject);
/// "bodies that touch are either; the depth is positive; A moves; directions have length 1".
std::string conventions_text(const Conventions& conventions);
/// The body that a claimed direction moves: "A" or "B".
const char* moving_body(const Conventions& conventions);
/// "epa_tolerance = 1e-4", sorted by name.
std::vector<std::string> settings_text(const SubjectInfo& subject);
/// "0.01 of every body"; "0.01 of vertices", one for each word.
std::vector<std::string> rounding_text(const SubjectInfo& subject);
/// "its own radii are larger than the bodies in 63 of 63 cases"; empty if they never are.
std::string dwarfed_text(const TallyRow& all);
/// "relative 1/1000, absolute 1/1000000 of the extent, 4 ulp; the largest counts; policy
/// within=5%"; a policy as declared is left out.
std::string tolerance_text(const Tolerance& tolerance);
/// "every case by a power of two: its longest side is less than 64, and at least half of that".
std::string fit_text(const mpq_class& fit);

/// Returns one sentence on an outcome: the judge's, and what the harness saw; without any, the name
/// of its verdict.
std::string sentence_of(const Outcome& outcome);

/// Three digits, "-4.44e-16"; an exact zero is "0".
std::string error_text(double error);
/// "10000 cases: 9000 pass, 990 fail, 10 unsupported; 2 unattributed"; without the last two where
/// there are none.
std::string totals_text(std::size_t total, std::size_t passes, std::size_t failures, std::size_t unattributed = 0);

/// "median 0 above the depth, worst 0.414, of 12 directions"; "3 longer translations pass by the
/// policy".
std::vector<std::string> excess_entries(const TallyRow& row);
/// The parts that are neither empty nor all of it, with their labels for people: "solid",
/// "metre-sized", "both".
std::vector<Tally::Line> shown_parts(const Tally& tally);

/// "correctly rounded: 61", "16 uR: 4": the classes that passes are in.
std::vector<std::string> accuracy_entries(const TallyRow& row);

// ---- the table that ends a run: what became of the cases of each family, and how large the errors
// were ----

class Summary {
 public:
  void add(const Outcome& outcome) { tally_.add(outcome); }
  void add(const Unattributed& unattributed) { ++unattributed_[unattributed.detail]; }

  /// Several lines, the last with its newline: the subject with its conventions and settings, a row
  /// for each family that fails and one for the others, or for each with `all_rows`, of `outcomes`
  /// the worst failures of each verdict by name, `where` to look for more, what was judged, what
  /// the words mean, totals. At most `columns` wide, or 40 if that is more, but for the numbers of
  /// a column and for words that are longer, and pure ASCII, whatever names hold; only the verdicts
  /// that occur have a column.
  [[nodiscard]] std::string table(const SubjectInfo& subject, std::span<const Outcome> outcomes = {},
                                  const std::vector<std::string>& where = {}, std::size_t columns = 140,
                                  bool all_rows = false) const;
  [[nodiscard]] std::size_t failures() const { return tally_.all().failures(); }
  [[nodiscard]] std::size_t passes() const { return tally_.all().passes(); }
  [[nodiscard]] std::size_t total() const { return tally_.all().total; }
  /// How often something happened that is no case's fault.
  [[nodiscard]] std::size_t unattributed() const { return sum(unattributed_); }
  [[nodiscard]] const UnattributedCounts& unattributed_counts() const { return unattributed_; }
  [[nodiscard]] const Tally& tally() const { return tally_; }

  std::optional<mpq_class> fit;  ///< the size that cases were brought to

 private:
  Tally tally_;
  UnattributedCounts unattributed_;
};

}  // namespace fathom::harness
