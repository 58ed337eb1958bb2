// SPDX-License-Identifier: GPL-3.0-or-later
// Of polytopes: every length is a rational or a root, and every comparison exact.                            [proofs/judge.md]
#include <fmt/format.h>

#include <cmath>

#include "fathom/numbers.hpp"
#include "verify/judge/allowance.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

double root(const mpq_class& squared) { return root_binary64(squared, Rounding::rn); }

class PolytopeMeasures final : public Measures {
 public:
  PolytopeMeasures(const Truth& truth, const NumberFormat& format, const Tolerance& tolerance)
      : truth_(truth),
        depth_(truth.depth),
        format_(format),
        tolerance_(tolerance),
        scene_(truth),
        squared_(truth.depth.squared()),
        allowed_(scene_.sizes(), squared_, format, tolerance) {}

  [[nodiscard]] std::optional<Status> status() const override { return depth_.status(); }
  bool is_deep() override { return !allowed_.classification.negligible(depth_.squared()); }
  bool is_far() override { return !depth_.distance() || !allowed_.classification.negligible(depth_.distance()->squared); }
  bool claims_depth(const mpq_class& d) override { return allowed_.classification.above(d, 0); }
  bool is_negative(const mpq_class& d) override { return allowed_.depth.below(d, 0); }
  bool too_long(const mpq_class& d) override { return allowed_.depth.above(d, squared_); }
  bool too_short(const mpq_class& d) override { return allowed_.depth.below(d, squared_); }
  bool is_inconsistent(const Vector& u, const mpq_class& d) override {
    return allowed_.direction.off(d, price_ && way_ == u ? *price_ : scene_.price(u));
  }
  bool is_dearer(const Vector& u, const mpq_class& times) override { return scene_.price(u) > times * times * depth_.squared(); }
  bool is_not_separating(const Vector& u, const mpq_class& d) override {
    return depth_.status() == Status::penetrating && allowed_.direction.below(d, travel(u));
  }
  bool is_off_a() override { return away_a_ && !allowed_.witness.negligible(*away_a_); }
  bool is_off_b() override { return away_b_ && !allowed_.witness.negligible(*away_b_); }
  bool is_contact_off_a() override { return contact_a_ && !allowed_.witness.negligible(*contact_a_); }
  bool is_contact_off_b() override { return contact_b_ && !allowed_.witness.negligible(*contact_b_); }
  bool is_off_length(const mpq_class& difference) override { return !allowed_.depth.negligible(difference * difference); }
  bool misses(const Surd& squared_gap) override { return !allowed_.gap.negligible(squared_gap); }
  Accuracy accuracy(const mpq_class& d) override { return accuracy_of(d, squared_, rounding_unit(), format_); }

  void measure(const Claim& claim, Judgement& result) override {
    result.status = depth_.status();
    result.depth_squared = depth_.squared();
    if (depth_.distance()) result.distance_squared = depth_.distance()->squared;
    if (!claim.overlap && claim.length) ask_for_distance(result.distance_squared);
    if (claim.length) measure_length(*claim.length, result);
    if (claim.direction) {
      result.travel_squared = travel(*claim.direction);
      price_ = result.price_squared = scene_.price(*claim.direction);
      if (claim.overlap && depth_.status() == Status::penetrating)
        result.dearer = kernels::nearest_binary64({-1, *price_ / depth_.squared()});
      if (claim.length) {
        result.inconsistency = kernels::nearest_binary64({claim.way(), -*price_});
        const Surd left{-claim.way(), *result.travel_squared};
        if (claim.overlap && depth_.status() == Status::penetrating && sign(left) > 0)
          result.overlap_left = kernels::nearest_binary64(left);
      }
    }
    if (claim.witness_a) away_a_ = result.witness_a_squared = squared_distance(*claim.witness_a, truth_.a);
    if (claim.witness_b) away_b_ = result.witness_b_squared = squared_distance(*claim.witness_b, truth_.b);
    for (const Point& contact : claim.contacts) {
      contact_a_ = std::max(contact_a_.value_or(0), squared_distance(contact, truth_.a));
      contact_b_ = std::max(contact_b_.value_or(0), squared_distance(contact, truth_.b));
    }
    result.contact_a_squared = contact_a_;
    result.contact_b_squared = contact_b_;
  }

  [[nodiscard]] std::string depth() const override { return fmt::format("{}", root(depth_.squared())); }
  [[nodiscard]] std::string distance() const override {
    return depth_.distance() ? fmt::format("{}", root(depth_.distance()->squared)) : "";
  }
  [[nodiscard]] std::string length() const override { return fmt::format("{}", root(squared_)); }
  [[nodiscard]] double off_by(const mpq_class& d) const override { return kernels::nearest_binary64({d, -squared_}); }
  [[nodiscard]] std::string left(const mpq_class& d) const override {
    return fmt::format("{:.4g} of overlap is left along its direction", std::abs(kernels::nearest_binary64({-d, travel_})));
  }
  [[nodiscard]] std::string across(const std::string& claimed) const override {
    return fmt::format("the plane across its direction is at {}, not at {}", kernels::nearest_binary64({0, *price_}), claimed);
  }
  [[nodiscard]] std::string gap(const std::string& claimed) const override {
    if (sgn(*price_) > 0) return "no plane across its direction separates the bodies";
    return fmt::format("the gap across its direction is {}, not {}", root(-*price_), claimed);
  }
  [[nodiscard]] double away_a() const override { return root(*away_a_); }
  [[nodiscard]] double away_b() const override { return root(*away_b_); }
  [[nodiscard]] double contact_away_a() const override { return root(*contact_a_); }
  [[nodiscard]] double contact_away_b() const override { return root(*contact_b_); }

 private:
  /// u R.
  [[nodiscard]] mpq_class rounding_unit() const { return unit_roundoff(format_.points) * scene_.sizes().farthest; }

  void ask_for_distance(const mpq_class& squared) {
    squared_ = squared;
    const Allowance classification = allowed_.classification;
    allowed_ = Allowances(scene_.sizes(), squared_, format_, tolerance_);
    allowed_.classification = classification;
  }

  void measure_length(const mpq_class& d, Judgement& result) const {
    const mpq_class &s = squared_, ulp = ulp_at_root(s, format_), u_r = rounding_unit();
    result.error = kernels::nearest_binary64({d, -s});
    if (sgn(s) > 0) {
      result.error_ulps = kernels::nearest_binary64({d / ulp, -s / (ulp * ulp)});
      result.error_relative = kernels::nearest_binary64({-1, d * abs(d) / s});
    }
    if (sgn(u_r) > 0) result.error_u_r = kernels::nearest_binary64({d / u_r, -s / (u_r * u_r)});
  }

  const mpq_class& travel(const Vector& u) {
    if (!way_ || *way_ != u) {
      travel_ = scene_.travel(u);
      price_.reset();
      way_ = u;
    }
    return travel_;
  }

  const Truth& truth_;
  const Depth& depth_;
  NumberFormat format_;
  const Tolerance& tolerance_;
  Scene scene_;
  mpq_class squared_;  // of the length in question
  Allowances allowed_;
  std::optional<mpq_class> price_, away_a_, away_b_, contact_a_, contact_b_;
  std::optional<Vector> way_;  // whose travel is known, and maybe whose price
  mpq_class travel_;
};

}  // namespace

std::unique_ptr<Measures> measures_of(const Truth& truth, const NumberFormat& format, const Tolerance& tolerance) {
  return std::make_unique<PolytopeMeasures>(truth, format, tolerance);
}

}  // namespace fathom::judging
