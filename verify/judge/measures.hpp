// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of the judge about the truth and a claim. For polytopes the truth is known exactly;
// for shapes it may lie between bounds.
//                                                                        [verify/judge/VERDICTS.md]
#pragma once

#include <gmpxx.h>

#include <memory>
#include <optional>
#include <string>

#include "fathom/judge.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "verify/judge/claim.hpp"

namespace fathom::judging {

/// The bits of bounds for shapes: at first, and at last if these leave a question open.
inline constexpr unsigned usual_bits = 40, most_bits = 160;

/// Answers questions about a claim. tol is the allowance of each residual: the tolerance, or the
/// slack if that is larger. Every yes is proved; if the bounds of the truth do not decide, the
/// answer is no, and `open` returns true. A claimed depth d may be negative; u is the direction in
/// which A moves. The length in question is the depth until a claim of a distance was measured,
/// then the distance; tol follows it.
class Measures {
 public:
  Measures() = default;
  Measures(const Measures&) = delete;
  Measures& operator=(const Measures&) = delete;
  virtual ~Measures() = default;

  [[nodiscard]] virtual std::optional<Status> status() const = 0;
  /// Returns whether the depth, the distance, or d itself exceeds the tolerance.
  virtual bool is_deep() = 0;
  virtual bool is_far() = 0;
  virtual bool claims_depth(const mpq_class& d) = 0;
  /// Returns whether -d exceeds tol.
  virtual bool is_negative(const mpq_class& d) = 0;
  /// Returns whether d is larger, or smaller, than the length in question by more than tol.
  virtual bool too_long(const mpq_class& d) = 0;
  virtual bool too_short(const mpq_class& d) = 0;
  /// Returns whether d, or its negative for a distance, differs from the separating distance of u
  /// by more than tol. For unions: whether A, moved by d along u, overlaps B or is apart from it by
  /// more than tol.
  virtual bool is_inconsistent(const Vector& u, const mpq_class& d) = 0;
  /// Returns whether the separating distance of u exceeds `times` the depth, without tolerance. For
  /// unions the claimed depth replaces the separating distance.
  virtual bool exceeds_depth(const Vector& u, const mpq_class& times) = 0;
  /// Returns whether the interiors meet, and still meet after a translation along u that is longer
  /// than d by more than tol.
  virtual bool is_not_separating(const Vector& u, const mpq_class& d) = 0;
  /// Returns true if `not_separating` already implies `inconsistent`; then only the former is
  /// reported.
  [[nodiscard]] virtual bool is_one_question() const { return false; }
  /// Returns whether a measured witness point is farther than tol from its body; `misses`, whether
  /// the distance of the points from the translation, given by its square, exceeds tol.
  virtual bool is_off_a() = 0;
  virtual bool is_off_b() = 0;
  /// Returns whether a measured contact of the claim, with its signs corrected, is farther from the
  /// body than its gap and tol together. Contacts that are outside do not count.
  virtual bool is_contact_off_a(const Claim& claim) = 0;
  virtual bool is_contact_off_b(const Claim& claim) = 0;
  /// Returns whether a difference of two claimed lengths exceeds tol.
  virtual bool is_off_length(const mpq_class& difference) = 0;
  virtual bool misses(const Surd& squared_gap) = 0;
  /// Returns the class of a length that is right.
  virtual Accuracy accuracy(const mpq_class& d) = 0;
  /// Returns whether closer bounds might change an answer.
  [[nodiscard]] virtual bool open() const { return false; }

  /// Writes the truth, and the residuals of the claim before corrections. Call it first.
  virtual void measure(const Claim& claim, Judgement& result) = 0;

  /// Returns the allowances, for polytopes and unions; else null. They are those of a depth until a
  /// claim of a distance was measured.
  [[nodiscard]] virtual const Allowances* allowances() const { return nullptr; }

  /// Writes the results of later measurements. Call it last.
  virtual void conclude(Judgement&) const {}

  // These functions return texts for sentences: the depth; and the distance, which may be unknown.
  [[nodiscard]] virtual std::string depth() const = 0;
  [[nodiscard]] virtual std::string distance() const = 0;
  /// Returns the length in question, and the difference of d from it.
  [[nodiscard]] virtual std::string length() const = 0;
  [[nodiscard]] virtual double off_by(const mpq_class& d) const = 0;
  /// Returns ", 1.581 times as much" for unions whose depth exceeds d; else "".
  [[nodiscard]] virtual std::string times(const mpq_class&) const { return ""; }
  /// Returns "0.4 of overlap is left along its direction", for the direction that was measured; and
  /// the separating distance of that direction, if it is not the claimed one.
  [[nodiscard]] virtual std::string left(const mpq_class& d) const = 0;
  [[nodiscard]] virtual std::string across(const std::string& claimed) const = 0;
  /// Returns "the gap across its direction is 0.3, not 0.5".
  [[nodiscard]] virtual std::string gap(const std::string& claimed) const = 0;
  [[nodiscard]] virtual double away_a() const = 0;
  [[nodiscard]] virtual double away_b() const = 0;
  /// Returns the farthest distance of contacts that is_contact_off_a, or is_contact_off_b, has
  /// found to be off.
  [[nodiscard]] virtual double contact_away_a() const = 0;
  [[nodiscard]] virtual double contact_away_b() const = 0;
};

std::unique_ptr<Measures> measures_of(const Truth& truth, const NumberFormat& format, const Tolerance& tolerance);
/// Returns measures whose bounds have `bits` bits.
std::unique_ptr<Measures> measures_of(const ShapeTruth& truth, const NumberFormat& format, const Tolerance& tolerance,
                                      unsigned bits);

std::unique_ptr<Measures> measures_of(const UnionTruth& truth, const NumberFormat& format, const Tolerance& tolerance,
                                      Monitor* monitor);

}  // namespace fathom::judging
