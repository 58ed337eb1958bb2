// SPDX-License-Identifier: GPL-3.0-or-later
// Input   a case that a subject fails, and the verdict.
// Output  a smaller case with the same verdict: fewer points and parts first, then fewer bits in
//         their numbers.                                                          [docs/certify.md]
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fathom/files.hpp"
#include "reference/files/shape_names.hpp"
#include "verify/harness/outcome.hpp"

namespace fathom::harness {

struct Shrunk {
  Case pair;                ///< the smallest case so far; every number is one of the subject's precision
  Outcome outcome;          ///< the subject's outcome on it
  std::string certificate;  ///< a certificate of the truth about it, which the checker has accepted
  std::size_t tried = 0;    ///< cases put to the subject, the first one included
  std::size_t kept = 0;     ///< number of smaller cases kept; each was certified and checked
  /// Whether the subject gave the verdict again on the first case; if not, no others were tried.
  bool reproduced = false;
};

struct ShrinkSettings {
  Precision precision = Precision::binary64;  ///< of the subject: coordinates are numbers of it
  std::size_t tries = 0;   ///< the most cases put to the subject; 0: 4000, or 100 if each try waits for a time-out
  bool keep_solid = true;  ///< a body with an interior keeps one: flat bodies fail for reasons of their own
  /// Returns the bodies that an answer is judged by, if they are not the case's; see judged_bodies.
  std::function<Case(const Case&, const Outcome&)> judged = {};
  bool certify = true;  ///< certify the truth about each kept case; if not, `certificate` stays empty
};

/// Searches for a smaller case by delta debugging, in passes until none helps. For points: drops
/// inner points and chunks of points, moves bodies to the origin, scales by powers of two, rounds
/// to ever fewer bits, down to small integers, makes coordinates 0, equal or smaller. For bodies by
/// name: drops margins, terms and vertices, removes rotations, simplifies numbers. A step is kept
/// only if the subject gives the same verdict again, and the case is smaller, so the search ends.
/// The truth about each kept case is certified anew and its certificate checked; throws
/// std::logic_error if the checker refuses it, or it contradicts the outcome's truth. `pair` is
/// rounded to the precision first. `on_better`, if set, is called at the start, if the verdict
/// occurred again, and for each kept step. `stop`, if set, is called before each try; if it returns
/// true, the search ends with the best case so far.
Shrunk shrink(const Case& pair, Verdict verdict, const Examine& examine,
              const std::function<void(const Shrunk&)>& on_better = {}, const std::function<bool()>& stop = {},
              const ShrinkSettings& settings = {});

// ---- the search, and its measures: sizes as a human sees them, and simpler numbers ----

/// The size of a case for its human reader. Fewer points come first, and for bodies by name fewer
/// vertices, fields, terms and matrices; then numbers of lower cost, then fewer signs.
struct Size {
  std::size_t points = 0, bits = 0, signs = 0;
  friend auto operator<=>(const Size&, const Size&) = default;
};

/// Returns the cost of a coordinate: 0 for 0; the bits of an integer below 1024; for any other
/// number the bits of its odd part, those of its exponent as the distance from 1, and 10 for not
/// being a small integer. The sign has no cost.
std::size_t cost(const mpq_class& value);

Size size_of(const Case& pair);

// ---- simpler numbers ----

/// Returns the integer nearest to `value`; halves are rounded up.
mpz_class nearest_integer(const mpq_class& value);

/// Rounds `value` to the nearest multiple of 2^exponent.
mpq_class to_multiple(const mpq_class& value, long exponent);

/// Rounds `value`, a binary fraction, to the nearest number with that many significant bits, at
/// least 1.
mpq_class to_bits(const mpq_class& value, long bits);

/// Returns simpler numbers to try in place of `value`, the simplest first; each has a lower cost
/// than `value`, or the same cost without its sign.
std::vector<mpq_class> simpler(const mpq_class& value);

/// The state of a search: the best so far, and the one way to replace it.
class Search {
 public:
  /// Takes the limits and callbacks of `shrink`; examines nothing yet.
  Search(Verdict verdict, const Examine& examine, const std::function<void(const Shrunk&)>& on_better,
         const std::function<bool()>& stop, const ShrinkSettings& settings);

  /// Examines the first case. Returns false if the subject does not give the verdict again.
  bool begin(Case pair);

  /// Keeps `candidate` if it is smaller than the best, its coordinates are numbers of the
  /// precision, and the subject gives the verdict on it. Each candidate is examined at most once.
  bool offer(Case candidate);

  /// Returns whether the limit is reached or the user stopped the search.
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

// A failing case as a program to paste into a bug report or a test.               [docs/certify.md]

/// Returns a whole C++ program that puts the case to the subject's library (libccd, FCL, Bullet,
/// ODE: info.library) by its own calls and prints its answer; for any other library, for bodies by
/// name, and for a wrong derivative, a GoogleTest that passes the recorded answer to fathom::judge,
/// whose first line says where to put the user's call instead. Coordinates are C99 hex floats. A
/// comment on top states the exact depth^2, the claim, the verdict, and how to compile it. `pair`
/// is the case as it was put to the subject.
std::string snippet(const SubjectInfo& info, const Case& pair, const Outcome& outcome);

// ---- the best case so far, on disk ----

/// The user's own program for a case; see filled_harness.
struct HarnessTemplate {
  std::string text;
  std::string ending = ".cpp";  ///< of its file, and of the files made from it
};
/// Throws InputError if the file cannot be read, or lacks both a mark for A and one for B.
HarnessTemplate read_harness(const std::string& path);

/// Writes <verdict>.case.json, <verdict>.cert and <verdict>.cpp (the user's own program, or the
/// snippet) into `directory`, which is made if needed. Each file is written under
/// another name and then renamed, so none is ever half written. A variant's verdict is followed by
/// "~<variant>". Returns the paths. Throws InputError naming the file that cannot be written.
std::vector<std::string> write_shrunk(const std::string& directory, const Shrunk& shrunk, const SubjectInfo& info,
                                      const std::optional<HarnessTemplate>& own = {});

/// Writes <stem>.case.json, the case with a comment, in the same way. Returns its path.
std::string write_case(const std::string& directory, const std::string& stem, const Case& pair,
                       const std::string& comment);

}  // namespace fathom::harness
