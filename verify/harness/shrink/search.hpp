// SPDX-License-Identifier: GPL-3.0-or-later
// The search for a smaller case, and what it compares: sizes as a human reader sees them, and
// simpler numbers.
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "verify/harness/shrink/shrink.hpp"

namespace fathom::harness {

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
