// SPDX-License-Identifier: GPL-3.0-or-later
// What the judge asks about the truth and a claim. Polytopes know the truth exactly; of shapes it
// may lie between bounds.
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

/// How close the bounds of shapes are: at first, and if they leave a question open at last.
inline constexpr unsigned usual_bits = 40, most_bits = 160;

/// tol is that of each residual: the tolerance, or the slack if that is larger. Every yes is
/// proved; where the bounds of the truth leave something open, the answer is no, and `open` tells.
/// A claimed depth d may be negative; u is the way that A moves. Once a claim of a distance was
/// measured, that is the length in question: tol is that of a distance.
class Measures {
 public:
  Measures() = default;
  Measures(const Measures&) = delete;
  Measures& operator=(const Measures&) = delete;
  virtual ~Measures() = default;

  [[nodiscard]] virtual std::optional<Status> status() const = 0;
  /// Whether the depth, the distance, or d itself is more than the tolerance.
  virtual bool is_deep() = 0;
  virtual bool is_far() = 0;
  virtual bool claims_depth(const mpq_class& d) = 0;
  /// Whether -d is more than tol.
  virtual bool is_negative(const mpq_class& d) = 0;
  /// Whether d is larger, or smaller, than the length in question by more than tol.
  virtual bool too_long(const mpq_class& d) = 0;
  virtual bool too_short(const mpq_class& d) = 0;
  /// Whether d, of a distance its negative, differs from the separating distance of u by more than
  /// tol. Of unions: whether A, moved by d along u, overlaps B or is apart from it by more than
  /// tol.
  virtual bool is_inconsistent(const Vector& u, const mpq_class& d) = 0;
  /// Whether the separating distance of u is more than `times` the depth, with no tolerance. Of
  /// unions the claimed depth is the separating distance.
  virtual bool exceeds_depth(const Vector& u, const mpq_class& times) = 0;
  /// Whether the interiors meet, and do so still after a way along u that is longer than d by more
  /// than tol.
  virtual bool is_not_separating(const Vector& u, const mpq_class& d) = 0;
  /// Returns true if `not_separating` already implies `inconsistent`; then only the former is
  /// reported.
  [[nodiscard]] virtual bool is_one_question() const { return false; }
  /// Whether a witness point that was measured is farther from its body than tol; and whether the
  /// points miss the translation by more, which is given by its square.
  virtual bool is_off_a() = 0;
  virtual bool is_off_b() = 0;
  /// Whether a contact of the claim that was measured, its signs mended, which is not outside, is
  /// farther from the body than tol, and its gap beside that.
  virtual bool is_contact_off_a(const Claim& claim) = 0;
  virtual bool is_contact_off_b(const Claim& claim) = 0;
  /// Whether a difference of two claimed lengths is more than tol.
  virtual bool is_off_length(const mpq_class& difference) = 0;
  virtual bool misses(const Surd& squared_gap) = 0;
  /// The class of a length that is right.
  virtual Accuracy accuracy(const mpq_class& d) = 0;
  /// Whether closer bounds might have changed an answer.
  [[nodiscard]] virtual bool open() const { return false; }

  /// Writes the truth, and the residuals of the claim as it stands. Comes first.
  virtual void measure(const Claim& claim, Judgement& result) = 0;

  /// What is allowed, of polytopes and unions; else null. That of a depth, until a claim of a
  /// distance was measured.
  [[nodiscard]] virtual const Allowances* allowances() const { return nullptr; }

  /// Writes what was measured since. Comes last.
  virtual void conclude(Judgement&) const {}

  // For people. The depth and the distance; the latter may be unknown.
  [[nodiscard]] virtual std::string depth() const = 0;
  [[nodiscard]] virtual std::string distance() const = 0;
  /// The length in question, and how far d is from it.
  [[nodiscard]] virtual std::string length() const = 0;
  [[nodiscard]] virtual double off_by(const mpq_class& d) const = 0;
  /// ", 1.581 times as much" of unions, whose depth is more than d; else empty.
  [[nodiscard]] virtual std::string times(const mpq_class&) const { return ""; }
  /// "0.4 of overlap is left along its direction", of the direction that was measured; and where
  /// the plane across it is, which is not as claimed.
  [[nodiscard]] virtual std::string left(const mpq_class& d) const = 0;
  [[nodiscard]] virtual std::string across(const std::string& claimed) const = 0;
  /// "the gap across its direction is 0.3, not 0.5".
  [[nodiscard]] virtual std::string gap(const std::string& claimed) const = 0;
  [[nodiscard]] virtual double away_a() const = 0;
  [[nodiscard]] virtual double away_b() const = 0;
  /// Of the contacts that is_contact_off_a, or _b, has found to be off, once it has, the farthest.
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
