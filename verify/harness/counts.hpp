// SPDX-License-Identifier: GPL-3.0-or-later
// What a run counts beside verdicts: how many answers could be judged, the time that they took, the hulls that they are about, and how much
// deeper unions are than they say. A subject whose answers have no depth, or misspell it, passes everything: coverage shows that.
//                                                                                                                    [docs/certify.md]
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verify/harness/outcome.hpp"

namespace fathom::harness {

/// How many answers held each field and were judged by it.
struct Coverage {
  std::size_t cases = 0;                              ///< outcomes of any kind
  std::size_t overlap = 0;                            ///< cases with an answer, whose classification was judged
  std::size_t overlapping = 0;                        ///< answers that say that the bodies overlap
  std::size_t depth = 0, direction = 0, witness = 0;  ///< answers with the field; without a depth the others are not judged
  std::size_t contacts = 0;                           ///< the same
  std::size_t distance = 0;                           ///< answers that say that they are apart, with a distance
  std::size_t without_depth = 0;                      ///< answers whose direction, witness points or contacts came without one

  void add(const Outcome& outcome);
  void add(const Coverage& other);
};

/// "overlap in 9 of 9 cases", "depth in 0 of the 9 said to overlap", "direction in 0", "witness in 0"; the first alone if none is.
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
  /// Of an even number the lower of the middle two. There must be one.
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
/// "the deepest pair is enough in 7 of 12", "deeper than the answer in 5", "1.581 times (key) at most"...; nothing without unions.
std::vector<std::string> union_entries(const UnionCount& unions);

}  // namespace fathom::harness
