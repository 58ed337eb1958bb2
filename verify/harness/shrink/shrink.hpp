// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a case that a subject fails, and the verdict.
// Output  a smaller case with the same verdict: fewer points and parts first, then fewer bits in
//         their numbers.                                                          [docs/certify.md]
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "verify/harness/outcome.hpp"

namespace fathom::harness {

struct Shrunk {
  Case pair;                ///< the smallest case so far; every number is one of the subject's precision
  Outcome outcome;          ///< what the subject made of it
  std::string certificate;  ///< proof of the truth about it: the text that checkers read, and the checker has accepted
  std::size_t tried = 0;    ///< cases put to the subject, the first one included
  std::size_t kept = 0;     ///< of them, smaller ones with the same verdict; each was certified and checked
  /// whether the subject gave the verdict again on the first case; if not, nothing was tried
  /// further
  bool reproduced = false;
};

struct ShrinkSettings {
  Precision precision = Precision::binary64;  ///< the subject's: coordinates stay in it
  std::size_t tries = 0;   ///< cases put to the subject at most; 0: 4000, or 100 where each try waits for a time-out
  bool keep_solid = true;  ///< a body with an interior keeps one: flat bodies fail for reasons of their own
  /// The bodies that an answer is judged on, if they are others than the case's; see judged_bodies.
  std::function<Case(const Case&, const Outcome&)> judged = {};
  bool certify = true;  ///< certify the truth about each kept case; if not, `certificate` stays empty
};

/// Of points, delta debugging, in passes until none helps: inner points and chunks of points
/// dropped, bodies moved to the origin, scaled by powers of two, rounded to ever fewer bits, down
/// to small integers, coordinates made 0, equal or smaller. Of bodies by name: margins, terms and
/// vertices dropped, turns undone, numbers made simpler. A step is kept only if the subject gives
/// the same verdict again, and the case is smaller: so it ends. The truth about each kept case is
/// certified anew and its certificate checked; std::logic_error if the checker refuses it, or it
/// contradicts the outcome's truth. `pair` is rounded to the precision first. `on_better`, if set,
/// is called at the start, if the verdict came again, and for each kept step. `stop`, if set, is
/// asked before each try; true ends the search with the best so far.
Shrunk shrink(const Case& pair, Verdict verdict, const Examine& examine,
              const std::function<void(const Shrunk&)>& on_better = {}, const std::function<bool()>& stop = {},
              const ShrinkSettings& settings = {});

}  // namespace fathom::harness
