// SPDX-License-Identifier: GPL-3.0-or-later
// Measures polytopes and unions of them: every length is a rational or a root, and every comparison
// exact. [proofs/judge.md]

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/vector.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

double root(const mpq_class& squared) { return root_binary64(squared, Rounding::rn); }

/// The part that polytopes and unions share: all questions except those about directions.
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
  bool is_contact_off_a(const Claim& claim) override;
  bool is_contact_off_b(const Claim& claim) override;
  bool is_off_length(const mpq_class& difference) override {
    return !allowed_.depth.negligible(difference * difference);
  }
  bool misses(const Surd& squared_gap) override { return !allowed_.gap.negligible(squared_gap); }
  Accuracy accuracy(const mpq_class& d) override { return accuracy_of(d, squared_, rounding_unit(), format_); }

  void measure(const Claim& claim, Judgement& result) final;
  [[nodiscard]] const Allowances* allowances() const override { return &allowed_; }

  [[nodiscard]] std::string depth() const override;
  [[nodiscard]] std::string distance() const override;
  [[nodiscard]] std::string length() const override;
  [[nodiscard]] double off_by(const mpq_class& d) const override;
  [[nodiscard]] double away_a() const override;
  [[nodiscard]] double away_b() const override;
  [[nodiscard]] double contact_away_a() const override;
  [[nodiscard]] double contact_away_b() const override;

 protected:
  /// Takes the squares of depth and distance; nullopt if the bodies are not disjoint, or if the
  /// distance is unknown. `tolerance` must outlive this object.
  ExactMeasures(Sizes sizes, Status status, mpq_class depth, std::optional<mpq_class> distance,
                const NumberFormat& format, const Tolerance& tolerance);

  /// Returns the squared distance of a point from A, or from B; 0 for points of the body.
  [[nodiscard]] virtual mpq_class squared_distance_a(const Point& point) const = 0;
  [[nodiscard]] virtual mpq_class squared_distance_b(const Point& point) const = 0;
  /// Writes the residuals of a direction, if there is one.
  virtual void measure_direction(const Claim& claim, Judgement& result) = 0;

  [[nodiscard]] const Allowance& of_direction() const { return allowed_.direction; }
  [[nodiscard]] const mpq_class& depth_squared() const { return depth_; }

 private:
  [[nodiscard]] mpq_class rounding_unit() const;  ///< u R
  /// Returns the greatest squared distance of the contacts that are off.
  [[nodiscard]] std::optional<mpq_class> farthest_off(const Claim& claim, const std::vector<mpq_class>& squared) const;
  void ask_for_distance(const mpq_class& squared);
  void measure_length(const mpq_class& d, Judgement& result) const;

  Sizes sizes_;
  Status status_;
  mpq_class depth_;                    // squared
  std::optional<mpq_class> distance_;  // squared
  NumberFormat format_;
  const Tolerance& tolerance_;
  mpq_class squared_;  // of the length in question: the depth or the distance
  Allowances allowed_;
  std::optional<mpq_class> away_a_, away_b_;
  std::vector<mpq_class> contacts_a_, contacts_b_;            // squared distances
  std::optional<mpq_class> contact_away_a_, contact_away_b_;  // the greatest of those that are off
};

ExactMeasures::ExactMeasures(Sizes sizes, Status status, mpq_class depth, std::optional<mpq_class> distance,
                             const NumberFormat& format, const Tolerance& tolerance)
    : sizes_(std::move(sizes)),
      status_(status),
      depth_(std::move(depth)),
      distance_(std::move(distance)),
      format_(format),
      tolerance_(tolerance),
      squared_(depth_),
      allowed_(sizes_, squared_, format, tolerance) {}

void ExactMeasures::measure(const Claim& claim, Judgement& result) {
  result.status = status_;
  result.depth_squared = depth_;
  if (distance_) result.distance_squared = *distance_;
  if (!claim.overlap && claim.length) ask_for_distance(result.distance_squared);
  if (claim.length) measure_length(*claim.length, result);
  measure_direction(claim, result);
  if (claim.witness_a) away_a_ = result.witness_a_squared = squared_distance_a(*claim.witness_a);
  if (claim.witness_b) away_b_ = result.witness_b_squared = squared_distance_b(*claim.witness_b);
  for (const Point& contact : claim.contacts) {
    contacts_a_.push_back(squared_distance_a(contact));
    contacts_b_.push_back(squared_distance_b(contact));
  }
  if (claim.contacts.empty()) return;
  result.contact_a_squared = *std::ranges::max_element(contacts_a_);
  result.contact_b_squared = *std::ranges::max_element(contacts_b_);
}

std::string ExactMeasures::depth() const { return fmt::format("{}", root(depth_)); }
std::string ExactMeasures::distance() const { return distance_ ? fmt::format("{}", root(*distance_)) : ""; }
std::string ExactMeasures::length() const { return fmt::format("{}", root(squared_)); }
double ExactMeasures::off_by(const mpq_class& d) const { return kernels::nearest_binary64({d, -squared_}); }
double ExactMeasures::away_a() const { return root(*away_a_); }
double ExactMeasures::away_b() const { return root(*away_b_); }
double ExactMeasures::contact_away_a() const { return root(contact_away_a_.value()); }
double ExactMeasures::contact_away_b() const { return root(contact_away_b_.value()); }

bool ExactMeasures::is_contact_off_a(const Claim& claim) {
  return (contact_away_a_ = farthest_off(claim, contacts_a_)).has_value();
}
bool ExactMeasures::is_contact_off_b(const Claim& claim) {
  return (contact_away_b_ = farthest_off(claim, contacts_b_)).has_value();
}

std::optional<mpq_class> ExactMeasures::farthest_off(const Claim& claim, const std::vector<mpq_class>& squared) const {
  std::optional<mpq_class> farthest;
  for (std::size_t k = 0; k < squared.size(); ++k)
    if (!claim.outside.contains(k) && !allowed_.witness.negligible(squared[k], claim.gap(k)))
      farthest = farthest ? std::max(*farthest, squared[k]) : squared[k];
  return farthest;
}

mpq_class ExactMeasures::rounding_unit() const { return unit_roundoff(format_.points) * sizes_.farthest; }

void ExactMeasures::ask_for_distance(const mpq_class& squared) {
  squared_ = squared;
  const Allowance classification = allowed_.classification;
  allowed_ = Allowances(sizes_, squared_, format_, tolerance_);
  allowed_.classification = classification;
}

void ExactMeasures::measure_length(const mpq_class& d, Judgement& result) const {
  const mpq_class &s = squared_, ulp = ulp_at_root(s, format_), u_r = rounding_unit();
  result.error = kernels::nearest_binary64({d, -s});
  if (sgn(s) > 0) {
    result.error_ulps = kernels::nearest_binary64({d / ulp, -s / (ulp * ulp)});
    result.error_relative = kernels::nearest_binary64({-1, d * abs(d) / s});
  }
  if (sgn(u_r) > 0) result.error_u_r = kernels::nearest_binary64({d / u_r, -s / (u_r * u_r)});
}

// ---- polytopes ----

std::optional<mpq_class> distance_of(const Depth& depth) {
  return depth.distance() ? std::optional(depth.distance()->squared) : std::nullopt;
}

/// Judges directions by the plane across them and the way along them.
class PolytopeMeasures final : public ExactMeasures {
 public:
  PolytopeMeasures(const Truth& truth, const NumberFormat& format, const Tolerance& tolerance)
      : ExactMeasures(sizes_of(truth.a, truth.b, truth.dimension), truth.depth.status(), truth.depth.squared(),
                      distance_of(truth.depth), format, tolerance),
        truth_(truth),
        scene_(truth) {}

  bool is_inconsistent(const Vector& u, const mpq_class& d) override {
    return of_direction().off(d, separating_distance_squared_ && way_ == u ? *separating_distance_squared_
                                                                           : scene_.separating_distance_squared(u));
  }
  bool exceeds_depth(const Vector& u, const mpq_class& times) override {
    return scene_.separating_distance_squared(u) > times * times * depth_squared();
  }
  bool is_not_separating(const Vector& u, const mpq_class& d) override {
    return status() == Status::penetrating && of_direction().below(d, exit_distance_squared(u));
  }

  [[nodiscard]] std::string left(const mpq_class& d) const override {
    return fmt::format("{:.4g} of overlap is left along its direction",
                       std::abs(kernels::nearest_binary64({-d, exit_distance_squared_})));
  }
  [[nodiscard]] std::string across(const std::string& claimed) const override {
    return fmt::format("the plane across its direction is at {}, not at {}",
                       kernels::nearest_binary64({0, *separating_distance_squared_}), claimed);
  }
  [[nodiscard]] std::string gap(const std::string& claimed) const override {
    if (sgn(*separating_distance_squared_) > 0) return "no plane across its direction separates the bodies";
    return fmt::format("the gap across its direction is {}, not {}", root(-*separating_distance_squared_), claimed);
  }

 private:
  [[nodiscard]] mpq_class squared_distance_a(const Point& point) const override {
    return squared_distance(point, truth_.a.exact());
  }
  [[nodiscard]] mpq_class squared_distance_b(const Point& point) const override {
    return squared_distance(point, truth_.b.exact());
  }

  void measure_direction(const Claim& claim, Judgement& result) override {
    if (!claim.direction) return;
    result.exit_distance_squared = exit_distance_squared(*claim.direction);
    separating_distance_squared_ = result.separating_distance_squared =
        scene_.separating_distance_squared(*claim.direction);
    const bool overlap = claim.overlap && status() == Status::penetrating;
    if (overlap)
      result.relative_excess = kernels::nearest_binary64({-1, *separating_distance_squared_ / depth_squared()});
    if (!claim.length) return;
    result.inconsistency = kernels::nearest_binary64({claim.way(), -*separating_distance_squared_});
    const Surd left{-claim.way(), *result.exit_distance_squared};
    if (overlap && sign(left) > 0) result.overlap_left = kernels::nearest_binary64(left);
  }

  const mpq_class& exit_distance_squared(const Vector& u) {
    if (!way_ || *way_ != u) {
      exit_distance_squared_ = scene_.exit_distance_squared(u);
      separating_distance_squared_.reset();
      way_ = u;
    }
    return exit_distance_squared_;
  }

  const Truth& truth_;
  Scene scene_;
  std::optional<mpq_class> separating_distance_squared_;
  std::optional<Vector> way_;  // the direction whose exit distance, and perhaps separating distance, is known
  mpq_class exit_distance_squared_;
};

// ---- unions ----

constexpr unsigned first_bits = 80, last_bits = 640;  // of the root in a translation

Pieces moved(const Pieces& pieces, const mpq_class& factor, const Vector& u) {
  const Point t = factor * u;
  Pieces result = pieces;
  for (std::vector<Point>& piece : result)
    for (Point& p : piece) p = p + t;
  return result;
}

/// Returns the square root less `off`, rounded down, or correctly rounded if `off` makes no
/// difference.
double least_root(const mpq_class& squared, const mpq_class& off) {
  const double low = kernels::nearest_binary64({-off, squared});
  if (low == kernels::nearest_binary64({off, squared})) return low;
  const mpq_class root = kernels::enclosed({0, squared}, last_bits).low - off;
  return sgn(root) > 0 ? round_binary64(root, Rounding::rd) : 0;
}

std::optional<mpq_class> distance_of(const UnionDepth& depth) {
  return depth.apart ? std::optional(depth.apart->distance.squared) : std::nullopt;
}

/// The position of the bodies after a translation.
struct Left {
  mpq_class depth, distance;  ///< squared, where A has moved by a rational vector
  mpq_class off;              ///< an upper bound of the distance between that vector and the translation in question
};

/// Judges a translation t by the signed depth of A + t and B, found by one more search. t is a
/// direction times a root, approximated to as many bits as a question needs.
class UnionMeasures final : public ExactMeasures {
 public:
  UnionMeasures(const UnionTruth& truth, const NumberFormat& format, const Tolerance& tolerance, Monitor* monitor)
      : ExactMeasures(sizes_of(truth.a, truth.b, truth.dimension), truth.depth.status, truth.depth.squared(),
                      distance_of(truth.depth), format, tolerance),
        truth_(truth),
        monitor_(monitor) {}

  bool is_inconsistent(const Vector& u, const mpq_class& d) override {
    return leaves(u, d, &Left::distance) || leaves(u, d, &Left::depth);
  }
  bool exceeds_depth(const Vector&, const mpq_class& times) override {
    return claimed_ * claimed_ > times * times * depth_squared();
  }
  bool is_not_separating(const Vector& u, const mpq_class& d) override {
    return status() == Status::penetrating && leaves(u, d, &Left::depth);
  }
  [[nodiscard]] bool is_one_question() const override { return true; }

  [[nodiscard]] std::string times(const mpq_class& d) const override {
    return sgn(d) > 0 ? fmt::format(", {:.4g} times as much", root_binary64(depth_squared() / (d * d), Rounding::rn))
                      : "";
  }
  [[nodiscard]] std::string left(const mpq_class&) const override {
    return fmt::format("{:.4g} of overlap is left after its translation", least_root(told_.depth, told_.off));
  }
  [[nodiscard]] std::string across(const std::string&) const override { return what_is_left(); }
  [[nodiscard]] std::string gap(const std::string&) const override { return what_is_left(); }

 private:
  [[nodiscard]] mpq_class squared_distance_a(const Point& point) const override {
    return squared_distance(point, truth_.a);
  }
  [[nodiscard]] mpq_class squared_distance_b(const Point& point) const override {
    return squared_distance(point, truth_.b);
  }

  void measure_direction(const Claim& claim, Judgement& result) override {
    if (claim.length) claimed_ = *claim.length;
    if (status() == Status::penetrating) result.bounds = truth_.depth.bounds;
    if (status() == Status::penetrating && claim.overlap && sgn(claimed_) > 0)
      result.deeper_squared = depth_squared() / (claimed_ * claimed_);
    if (!claim.direction || !claim.length) return;
    claimed_way_ = *claim.direction;
    const Left& left = after(*claim.direction, claim.way(), first_bits);
    const double overlap = least_root(left.depth, left.off), gap = least_root(left.distance, left.off);
    result.inconsistency = overlap > 0 ? -overlap : gap;
    if (claim.overlap && status() == Status::penetrating && overlap > 0) result.overlap_left = overlap;
  }

  /// Returns whether the depth, or the distance, after the translation exceeds tol.
  bool leaves(const Vector& u, const mpq_class& way, const mpq_class Left::*what) {
    for (unsigned bits = first_bits;; bits *= 2) {
      const Left& left = after(u, way, bits);
      if (u == claimed_way_) told_ = left;
      if (of_direction().below(left.off, left.*what)) return true;
      if (!of_direction().below(-left.off, left.*what)) return false;
      if (bits >= last_bits) return false;
    }
  }

  const Left& after(const Vector& u, const mpq_class& way, unsigned bits) {
    if (u == moved_along_ && way == moved_by_ && bits <= moved_bits_) return left_;
    const kernels::RationalInterval length = kernels::enclosed({0, mpq_class(dot(u, u))}, bits);
    const mpq_class factor = way / length.high;
    const Pieces a = moved(truth_.a, factor, u);
    UnionOptions options;
    options.monitor = monitor_;
    options.bounds = false;
    const UnionDepth depth = union_depth(a, truth_.b, options);
    if (!depth.complete) throw Interrupted();
    left_ = {depth.squared(), distance_of(depth).value_or(0), abs(factor) * (length.high - length.low)};
    moved_along_ = u;
    moved_by_ = way;
    moved_bits_ = length.low == length.high ? last_bits : bits;
    return left_;
  }

  [[nodiscard]] std::string what_is_left() const {
    const double overlap = least_root(told_.depth, told_.off);
    return overlap > 0 ? fmt::format("{:.4g} of overlap is left after its translation", overlap)
                       : fmt::format("its translation leaves a gap of {:.4g}", least_root(told_.distance, told_.off));
  }

  const UnionTruth& truth_;
  Monitor* monitor_;
  mpq_class claimed_;            // the claimed length
  Vector claimed_way_{0, 0, 0};  // the claimed direction
  Left told_;                    // after the claimed translation, with the sign of its length corrected
  // The last translation that was applied, as a direction and a length along it, and the position
  // after it:
  Vector moved_along_{0, 0, 0};
  mpq_class moved_by_;
  unsigned moved_bits_ = 0;
  Left left_;
};

}  // namespace

std::unique_ptr<Measures> measures_of(const Truth& truth, const NumberFormat& format, const Tolerance& tolerance) {
  return std::make_unique<PolytopeMeasures>(truth, format, tolerance);
}

std::unique_ptr<Measures> measures_of(const UnionTruth& truth, const NumberFormat& format, const Tolerance& tolerance,
                                      Monitor* monitor) {
  return std::make_unique<UnionMeasures>(truth, format, tolerance, monitor);
}

}  // namespace fathom::judging
