// SPDX-License-Identifier: GPL-3.0-or-later
// The counts of a run, which the tables of reports show: outcomes by family and verdict, with the
// worst and the median error; how many answers could be judged; their times; the hulls that they
// are about; and how much deeper unions are than their answers.
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

/// How many answers had each field and were judged by it. It reveals a subject that passes
/// everything because its answers lack a depth, or misspell it.
struct Coverage {
  std::size_t cases = 0;        ///< outcomes of any kind
  std::size_t overlap = 0;      ///< answers whose classification was judged
  std::size_t overlapping = 0;  ///< answers that claim an overlap
  /// Answers with the field. Without a depth the other fields are not judged.
  std::size_t depth = 0, direction = 0, witness = 0;
  std::size_t contacts = 0;       ///< likewise
  std::size_t distance = 0;       ///< answers that claim no overlap, with a distance
  std::size_t derivative = 0;     ///< answers whose derivative was judged
  std::size_t without_depth = 0;  ///< answers whose direction, witness points or contacts came without one

  void add(const Outcome& outcome);
  void add(const Coverage& other);
};

/// Returns "overlap in 9 of 9 cases", "depth in 0 of the 9 said to overlap", "direction in 0",
/// "witness in 0"; the first alone if no answer claims an overlap.
std::vector<std::string> coverage_entries(const Coverage& coverage);

/// Returns a sentence if answers claim overlaps and none has a depth; else "".
std::string coverage_warning(const Coverage& coverage);

/// A maximum, and the case where it was found: of several the one with the least id.
struct Most {
  double amount = 0;
  std::string id = {};  ///< with "~swap" of a variant; empty: there were no values
  void add(double other, const std::string& of);
};

/// Times of answers in microseconds, as the subject measured them.
class Times {
 public:
  void add(const Outcome& outcome);
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::size_t count() const { return all_.size(); }
  /// Returns the median; of an even number of values the lower of the middle two. There must be a
  /// value.
  [[nodiscard]] double median() const;
  [[nodiscard]] const Most& worst() const { return worst_; }

 private:
  std::vector<double> all_;
  Most worst_;
};

/// Answers that report their hulls.
struct HullCount {
  std::size_t count = 0, passed = 0;  ///< passed: judged by the hulls that were used
  Most lost, grown;                   ///< lengths in the unit of the cases, correctly rounded
  void add(const Outcome& outcome);
};

/// Judged answers about unions that overlap.
struct UnionCount {
  std::size_t count = 0, enough = 0;  ///< enough: the deepest pair of pieces is exactly as deep as the unions
  std::size_t answers = 0;            ///< answers with a depth above 0
  std::size_t deeper = 0;             ///< among these: the unions are deeper by more than the allowance
  Most times, by;                     ///< of those: the depth over the answer, and less the answer
  void add(const Outcome& outcome);
};

/// Returns "median 3.1 us", "worst 250 us (boxes-n8-s3)"; empty without times.
std::vector<std::string> time_entries(const Times& times);
/// Returns "told in 9 of 12 answers"...; empty without hulls.
std::vector<std::string> hull_entries(const HullCount& hulls);
/// Returns "the deepest pair is enough in 7 of 12", "deeper than the answer in 5", "1.581 times
/// (key) at most"...; empty without unions.
std::vector<std::string> union_entries(const UnionCount& unions);

/// The number of answers with wrong contacts, and of those with each finding, whatever other
/// findings they have.
struct ContactCount {
  std::size_t answers = 0;
  std::map<Verdict, std::size_t> findings;
  void add(const Outcome& outcome);
};
/// Returns "wrong in 3 answers", "misses-extent in 2"; empty if all are right.
std::vector<std::string> contact_entries(const ContactCount& contacts);

// ---- outcomes by family and verdict ----

inline constexpr std::size_t verdict_count = static_cast<std::size_t>(Verdict::pass) + 1;
inline constexpr std::size_t accuracy_count = static_cast<std::size_t>(Accuracy::tolerance) + 1;

/// Errors of claimed depths in one unit; below 0: too shallow. NaN is ignored.
class Errors {
 public:
  void add(double error);
  void add(const Errors& other);
  [[nodiscard]] bool empty() const { return errors_.empty(); }
  [[nodiscard]] std::size_t size() const { return errors_.size(); }
  /// Returns the error of the largest magnitude, with its sign; of equal magnitudes the positive
  /// one. There must be an error.
  [[nodiscard]] double worst() const;
  /// Returns the median of the magnitudes; of an even number the lower of the middle two. There
  /// must be an error.
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
  Errors relative_excess;          ///< separating distances of directions: their relative excess over the depth
  std::size_t dwarfed = 0;         ///< bodies that are smaller than the radii by which the subject rounds them
  std::size_t excess_allowed = 0;  ///< passes only by the policy: the translation is not the shortest

  void add(const Outcome& outcome);
  void add(const TallyRow& other);
  [[nodiscard]] std::size_t operator[](Verdict verdict) const { return verdicts[static_cast<std::size_t>(verdict)]; }
  [[nodiscard]] std::size_t failures() const;
  [[nodiscard]] std::size_t passes() const;
};

/// A row for each family, then one for each symmetry, "~swap"; variants are not counted in
/// families.
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
  /// Returns the rows, without the one of all: families that fail first, those with the most
  /// failures before others, then by name. Beyond `most` families the rest share one row, "(3
  /// more)".
  [[nodiscard]] std::vector<Line> lines(std::size_t most = 100) const;
  /// Returns the same, but families without a failure share one row, "64 families pass", or "(3 not
  /// judged)" if all their cases were declined.
  [[nodiscard]] std::vector<Line> failing_lines() const;
  /// Returns the rows of all outcomes, symmetries included: "solid", "metre_sized", and
  /// "solid_and_metre_sized".
  [[nodiscard]] const std::vector<Line>& parts() const { return parts_; }
  /// Returns the verdicts that occur, passes first, then in order of rank.
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

// ---- failures in order of severity ----

/// Returns the indices of the failures, worst first. Equal ones follow by id and variant, so that
/// the order does not depend on the order of answers in a parallel run.
std::vector<std::size_t> worst_first(std::span<const Outcome> outcomes);

/// Returns these indices for each verdict.
std::map<Verdict, std::vector<std::size_t>> worst_failures(std::span<const Outcome> outcomes);

// ---- the run, as every report describes it ----

/// Failures that no case caused: the number of each sentence.
using UnattributedCounts = std::map<std::string, std::size_t>;

inline std::size_t sum(const UnattributedCounts& counts) {
  std::size_t result = 0;
  for (const auto& [detail, count] : counts) result += count;
  return result;
}

/// The version of fathom, its command line, and the course of the run. Every report has them.
struct RunInfo {
  std::string version;    ///< "0.1.0"
  std::string command;    ///< the command line, quoted for a shell
  std::string cut_short;  ///< why the run ended before every case was judged; empty if it did not
  UnattributedCounts unattributed = {};
  std::vector<Method> second = {};              ///< methods that computed every truth again, and agreed
  std::optional<mpq_class> fit = std::nullopt;  ///< the size to which each case was brought; see exponent_to_fit
};

}  // namespace fathom::harness
