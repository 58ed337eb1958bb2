// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a search for a smaller case: the best so far, and the one way to replace it. Not a door: that is shrink.hpp.
#pragma once

#include <set>
#include <string>

#include "verify/harness/shrink/shrink.hpp"

namespace fathom::harness {

class Search {
 public:
  /// Takes the limits and callbacks of `shrink`; examines nothing yet.
  Search(Verdict verdict, const Examine& examine, const std::function<void(const Shrunk&)>& on_better, const std::function<bool()>& stop,
         const ShrinkSettings& settings);

  /// Examines the first case. Returns false if the verdict did not come again.
  bool begin(Case pair);

  /// Keeps `candidate` if it is smaller than the best, its coordinates are numbers of the precision, and the subject gives the verdict on
  /// it. Each candidate is examined at most once.
  bool offer(Case candidate);

  /// Whether the limit is reached or the user stopped the search.
  [[nodiscard]] bool over() const { return over_; }
  [[nodiscard]] const Case& best() const { return result_.pair; }
  [[nodiscard]] Precision precision() const { return precision_; }
  [[nodiscard]] const Shrunk& result() const { return result_; }

 private:
  bool keep(Case pair, Outcome outcome);

  Verdict verdict_;
  const Examine& examine_;
  const std::function<void(const Shrunk&)>& on_better_;
  const std::function<bool()>& stop_;
  Precision precision_;
  const std::function<Case(const Case&, const Outcome&)>& judged_;
  std::size_t tries_;
  bool keep_solid_, certify_, solid_a_ = false, solid_b_ = false;  ///< whether the bodies have to keep an interior
  bool over_ = false;
  Shrunk result_;
  Size size_;
  std::set<std::string> examined_;  ///< the coordinates of all cases that were tried
};

}  // namespace fathom::harness
