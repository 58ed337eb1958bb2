// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a case that a subject fails, and the verdict.
// Output  a smaller case with the same verdict: fewer points and parts first, then fewer bits in
//         their numbers.                                                          [docs/certify.md]
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "fathom/files.hpp"
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

// ---- the search, and what it compares: sizes as a human sees them, and simpler numbers ----

/// How large a case is for its human reader. Fewer points come first, and of bodies by name fewer
/// vertices, fields, terms and matrices; then cheaper numbers, then fewer signs.
struct Size {
  std::size_t points = 0, bits = 0, signs = 0;
  friend auto operator<=>(const Size&, const Size&) = default;
};

/// What a coordinate costs: nothing for 0; an integer below 1024 its bits; of any other number the
/// bits of its odd part, those of its exponent as the distance from 1, and 10 for not being a small
/// integer. The sign costs nothing.
std::size_t cost(const mpq_class& value);

Size size_of(const Case& pair);

// ---- simpler numbers ----

/// The integer nearest to `value`; halves go up.
mpz_class nearest_integer(const mpq_class& value);

/// `value` to the nearest multiple of 2^exponent.
mpq_class to_multiple(const mpq_class& value, long exponent);

/// Rounds `value`, a binary fraction, to the nearest number with that many significant bits, at
/// least 1.
mpq_class to_bits(const mpq_class& value, long bits);

/// Simpler numbers to try in place of `value`, the simplest first; each costs less than `value`, or
/// the same without its sign.
std::vector<mpq_class> simpler(const mpq_class& value);

/// The state of a search: the best so far, and the one way to replace it.
class Search {
 public:
  /// Takes the limits and callbacks of `shrink`; examines nothing yet.
  Search(Verdict verdict, const Examine& examine, const std::function<void(const Shrunk&)>& on_better,
         const std::function<bool()>& stop, const ShrinkSettings& settings);

  /// Examines the first case. Returns false if the verdict did not come again.
  bool begin(Case pair);

  /// Keeps `candidate` if it is smaller than the best, its coordinates are numbers of the
  /// precision, and the subject gives the verdict on it. Each candidate is examined at most once.
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
