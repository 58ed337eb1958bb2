// SPDX-License-Identifier: GPL-3.0-or-later
// Outcomes counted: by family and verdict, with the worst and the median error. What the tables of a run show.    [docs/certify.md]
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "verify/harness/outcome.hpp"
#include "verify/harness/tally.hpp"

namespace fathom::harness {

inline constexpr std::size_t verdict_count = static_cast<std::size_t>(Verdict::pass) + 1;
inline constexpr std::size_t accuracy_count = static_cast<std::size_t>(Accuracy::tolerance) + 1;

/// Errors of claimed depths in one unit; below 0: too shallow. NaN is left out.
class Errors {
 public:
  void add(double error);
  void add(const Errors& other);
  [[nodiscard]] bool empty() const { return errors_.empty(); }
  [[nodiscard]] std::size_t size() const { return errors_.size(); }
  /// The one of the largest magnitude, with its sign; of equal magnitudes the positive one. There must be one.
  [[nodiscard]] double worst() const;
  /// The median of the magnitudes; of an even number the lower of the middle two. There must be one.
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
  Errors dearer;            ///< prices of directions, above the depth and relative to it
  std::size_t dwarfed = 0;  ///< bodies that are smaller than the radii by which the subject rounds them
  std::size_t longer = 0;   ///< passes by the policy, whose translation is not the shortest

  void add(const Outcome& outcome);
  void add(const TallyRow& other);
  [[nodiscard]] std::size_t operator[](Verdict verdict) const { return verdicts[static_cast<std::size_t>(verdict)]; }
  [[nodiscard]] std::size_t failures() const;
  [[nodiscard]] std::size_t passes() const;
};

/// A row for each family, then one for each symmetry that cases were put through: "~swap"; those count in no family.
class Tally {
 public:
  void add(const Outcome& outcome);
  [[nodiscard]] const TallyRow& all() const { return all_; }
  [[nodiscard]] const Times& times() const { return times_; }
  [[nodiscard]] const HullCount& hulls() const { return hulls_; }
  [[nodiscard]] const UnionCount& unions() const { return unions_; }

  struct Line {
    std::string label;  ///< of outcomes without a family: "(no family)"; printable ASCII, at most 32 characters
    TallyRow row;
  };
  /// Families that fail first, those with the most failures before others, then by name. Past `most` families the rest share one line,
  /// "(3 more)". Without the row of all.
  [[nodiscard]] std::vector<Line> lines(std::size_t most = 100) const;
  /// The same, but families without a failure share one line, "64 families pass", or "(3 not judged)" if all was declined.
  [[nodiscard]] std::vector<Line> failing_lines() const;
  /// Of all outcomes, symmetries included: "solid", "metre_sized", and "solid_and_metre_sized".
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
  std::vector<Line> parts_{{"solid", {}}, {"metre_sized", {}}, {"solid_and_metre_sized", {}}};
  std::map<std::string, TallyRow> families_, variants_;
};

}  // namespace fathom::harness
