// SPDX-License-Identifier: GPL-3.0-or-later
// What a run counts, and what the tables of reports show: outcomes by family and verdict, with the
// worst and the median error; how many answers could be judged, the time that they took, the hulls
// that they are about, and how much deeper unions are than they say.
//                                                                                 [docs/certify.md]
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fathom/depth.hpp"
#include "verify/harness/outcome.hpp"

namespace fathom::harness {

/// How many answers held each field and were judged by it. A subject whose answers have no depth,
/// or misspell it, passes everything: this shows that.
struct Coverage {
  std::size_t cases = 0;        ///< outcomes of any kind
  std::size_t overlap = 0;      ///< cases with an answer, whose classification was judged
  std::size_t overlapping = 0;  ///< answers that say that the bodies overlap
  /// answers with the field; without a depth the others are not judged
  std::size_t depth = 0, direction = 0, witness = 0;
  std::size_t contacts = 0;       ///< the same
  std::size_t distance = 0;       ///< answers that say that they are apart, with a distance
  std::size_t derivative = 0;     ///< answers whose derivative was judged
  std::size_t without_depth = 0;  ///< answers whose direction, witness points or contacts came without one

  void add(const Outcome& outcome);
  void add(const Coverage& other);
};

/// "overlap in 9 of 9 cases", "depth in 0 of the 9 said to overlap", "direction in 0", "witness in
/// 0"; the first alone if none is.
std::vector<std::string> coverage_entries(const Coverage& coverage);

/// A sentence if answers say that bodies overlap and none has a depth; else empty.
std::string coverage_warning(const Coverage& coverage);

/// The most of something, and the case where it was: of several the one with the least name.
struct Most {
  double amount = 0;
  std::string id = {};  ///< with "~swap" of a variant; empty: there was nothing
  void add(double other, const std::string& of);
};

/// Microseconds of answers, as the subject measured them.
class Times {
 public:
  void add(const Outcome& outcome);
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::size_t count() const { return all_.size(); }
  /// Returns the median, of an even number the lower of the middle two. There must be one.
  [[nodiscard]] double median() const;
  [[nodiscard]] const Most& worst() const { return worst_; }

 private:
  std::vector<double> all_;
  Most worst_;
};

/// Answers that told their hulls.
struct HullCount {
  std::size_t count = 0, passed = 0;  ///< passed: by the hulls that were used
  Most lost, grown;                   ///< lengths in the unit of the cases, correctly rounded
  void add(const Outcome& outcome);
};

/// Judged answers about unions that overlap.
struct UnionCount {
  std::size_t count = 0, enough = 0;  ///< enough: the deepest pair of pieces is exactly as deep as the unions
  std::size_t answers = 0;            ///< that say a depth above 0
  std::size_t deeper = 0;             ///< of these: the unions are deeper by more than what is allowed
  Most times, by;                     ///< of those: the depth over the answer, and less the answer
  void add(const Outcome& outcome);
};

/// "median 3.1 us", "worst 250 us (boxes-n8-s3)"; nothing without times.
std::vector<std::string> time_entries(const Times& times);
/// "told in 9 of 12 answers"... ; nothing without hulls.
std::vector<std::string> hull_entries(const HullCount& hulls);
/// "the deepest pair is enough in 7 of 12", "deeper than the answer in 5", "1.581 times (key) at
/// most"...; nothing without unions.
std::vector<std::string> union_entries(const UnionCount& unions);

/// Answers whose contacts are not right, and those in which each finding is made, whatever else is
/// wrong with them.
struct ContactCount {
  std::size_t answers = 0;
  std::map<Verdict, std::size_t> findings;
  void add(const Outcome& outcome);
};
/// "wrong in 3 answers", "misses-extent in 2"; empty if all are right.
std::vector<std::string> contact_entries(const ContactCount& contacts);

// ---- outcomes by family and verdict ----

inline constexpr std::size_t verdict_count = static_cast<std::size_t>(Verdict::pass) + 1;
inline constexpr std::size_t accuracy_count = static_cast<std::size_t>(Accuracy::tolerance) + 1;

/// Errors of claimed depths in one unit; below 0: too shallow. NaN is left out.
class Errors {
 public:
  void add(double error);
  void add(const Errors& other);
  [[nodiscard]] bool empty() const { return errors_.empty(); }
  [[nodiscard]] std::size_t size() const { return errors_.size(); }
  /// The one of the largest magnitude, with its sign; of equal magnitudes the positive one. There
  /// must be one.
  [[nodiscard]] double worst() const;
  /// The median of the magnitudes; of an even number the lower of the middle two. There must be
  /// one.
  [[nodiscard]] double median() const;

 private:
  std::vector<double> errors_;
};

struct TallyRow {
  std::array<std::size_t, verdict_count> verdicts{};     ///< how many outcomes have each verdict
  std::array<std::size_t, accuracy_count> accuracies{};  ///< how many passes are in each class
  std::size_t total = 0;
  Coverage judged;
  Errors relative, u_r;
  Errors relative_excess;          ///< separating distances of directions, above the depth and relative to it
  std::size_t dwarfed = 0;         ///< bodies that are smaller than the radii by which the subject rounds them
  std::size_t excess_allowed = 0;  ///< passes by the policy, whose translation is not the shortest

  void add(const Outcome& outcome);
  void add(const TallyRow& other);
  [[nodiscard]] std::size_t operator[](Verdict verdict) const { return verdicts[static_cast<std::size_t>(verdict)]; }
  [[nodiscard]] std::size_t failures() const;
  [[nodiscard]] std::size_t passes() const;
};

/// A row for each family, then one for each symmetry that cases were put through: "~swap"; those
/// count in no family.
class Tally {
 public:
  void add(const Outcome& outcome);
  [[nodiscard]] const TallyRow& all() const { return all_; }
  [[nodiscard]] const Times& times() const { return times_; }
  [[nodiscard]] const HullCount& hulls() const { return hulls_; }
  [[nodiscard]] const UnionCount& unions() const { return unions_; }
  [[nodiscard]] const ContactCount& contacts() const { return contacts_; }

  struct Line {
    std::string label;  ///< of outcomes without a family: "(no family)"; printable ASCII, at most 32 characters
    TallyRow row;
  };
  /// Families that fail first, those with the most failures before others, then by name. Past
  /// `most` families the rest share one line, "(3 more)". Without the row of all.
  [[nodiscard]] std::vector<Line> lines(std::size_t most = 100) const;
  /// The same, but families without a failure share one line, "64 families pass", or "(3 not
  /// judged)" if all was declined.
  [[nodiscard]] std::vector<Line> failing_lines() const;
  /// Returns the rows of all outcomes, symmetries included: "solid", "metre_sized", and
  /// "solid_and_metre_sized".
  [[nodiscard]] const std::vector<Line>& parts() const { return parts_; }
  /// The verdicts that occur, passes first, then in order of rank.
  [[nodiscard]] std::vector<Verdict> verdicts() const;

 private:
  [[nodiscard]] std::vector<Line> ordered() const;
  void add_variants(std::vector<Line>& to) const;

  TallyRow all_;
  Times times_;
  HullCount hulls_;
  UnionCount unions_;
  ContactCount contacts_;
  std::vector<Line> parts_{{"solid", {}}, {"metre_sized", {}}, {"solid_and_metre_sized", {}}};
  std::map<std::string, TallyRow> families_, variants_;
};

// ---- failures in the order in which they deserve attention ----

/// The indices of the failures, worst first. Equals follow by id and variant, so that the order
/// does not depend on which answer of a parallel run came first.
std::vector<std::size_t> worst_first(std::span<const Outcome> outcomes);

/// Returns these indices for each verdict.
std::map<Verdict, std::vector<std::size_t>> worst_failures(std::span<const Outcome> outcomes);

// ---- what a report says of its run ----

/// Failures that no case caused, by their wording, with their number.
using UnattributedCounts = std::map<std::string, std::size_t>;

inline std::size_t sum(const UnattributedCounts& counts) {
  std::size_t result = 0;
  for (const auto& [detail, count] : counts) result += count;
  return result;
}

/// Which fathom judged, how it was called, and how it went. Every report says so.
struct RunInfo {
  std::string version;    ///< "0.1.0"
  std::string command;    ///< the command line, ready for a shell
  std::string cut_short;  ///< why the run ended before every case was judged; empty if it did not
  UnattributedCounts unattributed = {};
  std::vector<Method> second = {};              ///< methods that found every truth again, and agreed
  std::optional<mpq_class> fit = std::nullopt;  ///< the size that each case was brought to; see exponent_to_fit
};

}  // namespace fathom::harness
