// SPDX-License-Identifier: GPL-3.0-or-later
// What polytopes and unions of them have in common: every length is a rational or a root, and every comparison exact. [proofs/judge.md]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>

#include "verify/judge/allowance.hpp"
#include "verify/judge/measures.hpp"

namespace fathom::judging {

/// All questions but those about directions.
class ExactMeasures : public Measures {
 public:
  [[nodiscard]] std::optional<Status> status() const override { return status_; }
  bool is_deep() override { return !allowed_.classification.negligible(depth_); }
  bool is_far() override { return !distance_ || !allowed_.classification.negligible(*distance_); }
  bool claims_depth(const mpq_class& d) override { return allowed_.classification.above(d, 0); }
  bool is_negative(const mpq_class& d) override { return allowed_.depth.below(d, 0); }
  bool too_long(const mpq_class& d) override { return allowed_.depth.above(d, squared_); }
  bool too_short(const mpq_class& d) override { return allowed_.depth.below(d, squared_); }
  bool is_off_a() override { return away_a_ && !allowed_.witness.negligible(*away_a_); }
  bool is_off_b() override { return away_b_ && !allowed_.witness.negligible(*away_b_); }
  bool is_contact_off_a() override { return contact_a_ && !allowed_.witness.negligible(*contact_a_); }
  bool is_contact_off_b() override { return contact_b_ && !allowed_.witness.negligible(*contact_b_); }
  bool is_off_length(const mpq_class& difference) override { return !allowed_.depth.negligible(difference * difference); }
  bool misses(const Surd& squared_gap) override { return !allowed_.gap.negligible(squared_gap); }
  Accuracy accuracy(const mpq_class& d) override { return accuracy_of(d, squared_, rounding_unit(), format_); }

  void measure(const Claim& claim, Judgement& result) final;

  [[nodiscard]] std::string depth() const override;
  [[nodiscard]] std::string distance() const override;
  [[nodiscard]] std::string length() const override;
  [[nodiscard]] double off_by(const mpq_class& d) const override;
  [[nodiscard]] double away_a() const override;
  [[nodiscard]] double away_b() const override;
  [[nodiscard]] double contact_away_a() const override;
  [[nodiscard]] double contact_away_b() const override;

 protected:
  /// The squares of depth and distance; there is none of bodies that are not disjoint, or where it is not known. `tolerance` outlives it.
  ExactMeasures(Sizes sizes, Status status, mpq_class depth, std::optional<mpq_class> distance, const NumberFormat& format,
                const Tolerance& tolerance);

  /// The squared distance of a point from A, or from B; 0 on the body.
  [[nodiscard]] virtual mpq_class squared_distance_a(const Point& point) const = 0;
  [[nodiscard]] virtual mpq_class squared_distance_b(const Point& point) const = 0;
  /// Writes the residuals of a direction, if there is one.
  virtual void measure_direction(const Claim& claim, Judgement& result) = 0;

  [[nodiscard]] const Allowance& of_direction() const { return allowed_.direction; }
  [[nodiscard]] const mpq_class& depth_squared() const { return depth_; }

 private:
  [[nodiscard]] mpq_class rounding_unit() const;  ///< u R
  void ask_for_distance(const mpq_class& squared);
  void measure_length(const mpq_class& d, Judgement& result) const;

  Sizes sizes_;
  Status status_;
  mpq_class depth_;                    // squared
  std::optional<mpq_class> distance_;  // squared
  NumberFormat format_;
  const Tolerance& tolerance_;
  mpq_class squared_;  // of the length in question
  Allowances allowed_;
  std::optional<mpq_class> away_a_, away_b_, contact_a_, contact_b_;
};

}  // namespace fathom::judging
