// SPDX-License-Identifier: GPL-3.0-or-later
// Measures shapes: every length lies between two rationals, and an answer is yes only if it is so
// for all values between them. Exact signed depths are enclosed with the requested number of bits,
// or known if they are rational. [proofs/judge.md]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "kernels/vector.hpp"
#include "reference/shapes/core.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/scene.hpp"

namespace fathom::judging {
namespace {

using kernels::RationalInterval;

RationalInterval known(const mpq_class& value) { return {value, value}; }
RationalInterval operator/(const RationalInterval& x, const mpq_class& divisor) {
  return {x.low / divisor, x.high / divisor};
}

Between outward(const RationalInterval& x) {
  return {round_binary64(x.low, Rounding::rd), round_binary64(x.high, Rounding::ru)};
}

/// Returns the value correctly rounded if that is known; else the least of the values, rounded
/// towards 0.
double least(const RationalInterval& x) {
  const double nearest = round_binary64(x.low);
  if (nearest == round_binary64(x.high)) return nearest + 0.0;
  if (sgn(x.low) > 0) return round_binary64(x.low, Rounding::rd);
  return sgn(x.high) < 0 ? round_binary64(x.high, Rounding::ru) : 0.0;
}

/// Returns as many digits as are certain, if these are enough to be useful.
std::string text(const RationalInterval& x) {
  constexpr int most = 17, enough = 6;
  const double nearest = round_binary64(x.low);
  if (nearest == round_binary64(x.high)) return fmt::format("{}", nearest + 0.0);
  const Between range = outward(x);
  for (int digits = most; digits >= enough; --digits) {
    std::string low = fmt::format("{:.{}g}", range.low, digits);
    if (low == fmt::format("{:.{}g}", range.high, digits)) return low;
  }
  return fmt::format("between {} and {}", range.low, range.high);
}

RationalInterval magnitude(const RationalInterval& x) { return greater(positive_part(x), positive_part(-x)); }

Shape without(Shape shape, const mpq_class& radius) {
  shape.radius -= radius;
  return shape;
}

Point point_of(const Vector& u) { return {u.x, u.y, u.z}; }

Shape translated(const Shape& shape, const mpq_class& factor, const Vector& u) {
  return moved(shape, rigid_pose({1, 0, 0, 0}, factor * u));
}

class ShapeMeasures final : public Measures {
 public:
  ShapeMeasures(const ShapeTruth& truth, const NumberFormat& format, const Tolerance& tolerance, unsigned bits)
      : truth_(truth),
        format_(format),
        tolerance_(tolerance),
        bits_(bits),
        added_(truth.added_a + truth.added_b),
        sizes_(sizes_of(truth.a, truth.b, bits, truth.dimension)) {
    asked_ = added_ == 0
                 ? sizes_
                 : sizes_of(without(truth.a, truth.added_a), without(truth.b, truth.added_b), bits, truth.dimension);
    const SignedDepth* signed_depth = &truth.depth;
    if (bits != usual_bits && truth.depth.bounds()) signed_depth = &closer_.emplace(of(truth.a));
    status_ = signed_depth->status();
    open_ = !status_;
    value_ = enclosed(*signed_depth);
    depth_ = positive_part(value_);
    ask_for(depth_);
    classification_ = allowed(tolerance_.ulps * ulp_at_root(depth_.high * depth_.high, format_), depth_);
  }

  [[nodiscard]] std::optional<Status> status() const override { return status_; }
  bool is_deep() override { return below(0, depth_, classification_); }
  bool is_far() override { return below(0, positive_part(-value_), classification_); }
  bool claims_depth(const mpq_class& d) override { return above(d, known(0), classification_); }
  bool is_negative(const mpq_class& d) override { return below(d, known(0), of_length_); }
  bool too_long(const mpq_class& d) override { return above(d, length_, of_length_); }
  bool too_short(const mpq_class& d) override { return below(d, length_, of_length_); }

  bool is_inconsistent(const Vector& u, const mpq_class& d) override {
    const std::optional<RationalInterval> separating = separating_distance_of(u);
    return !separating || above(d, *separating, of_direction_) || below(d, *separating, of_direction_);
  }

  bool exceeds_depth(const Vector& u, const mpq_class& times) override {
    const std::optional<RationalInterval> separating = separating_distance_of(u);
    return !separating || exceeds(*separating - RationalInterval{times * depth_.low, times * depth_.high}, known(0));
  }

  bool is_not_separating(const Vector& u, const mpq_class& d) override {
    if (status_ != Status::penetrating) return false;
    const std::optional<RationalInterval> separating = separating_distance_of(u);
    if (has_halfspace()) {  // for a half-space this is the exit distance
      if (separating && !below(d, *separating, of_direction_)) return false;
      if (separating) left_ = round_binary64(separating->low - d, Rounding::rd);
      return true;
    }
    if (separating->high <= d + of_direction_.low) return false;
    const mpq_class way = d + of_direction_.high;
    const bool meet = depth_.low > way || still_meet(u, way);
    if (meet) find_left(u, d, way, separating->high);
    return meet;
  }

  bool is_off_a() override { return away_a_ && below(0, *away_a_, of_witness_); }
  bool is_off_b() override { return away_b_ && below(0, *away_b_, of_witness_); }
  bool is_contact_off_a(const Claim& claim) override {
    return (contact_away_a_ = farthest_off(claim, contacts_a_)).has_value();
  }
  bool is_contact_off_b(const Claim& claim) override {
    return (contact_away_b_ = farthest_off(claim, contacts_b_)).has_value();
  }
  bool is_off_length(const mpq_class& difference) override { return above(abs(difference), known(0), of_length_); }
  bool misses(const Surd& squared_gap) override {
    if (compare(squared_gap, of_gap_.high * of_gap_.high) > 0) return true;
    open_ = open_ || compare(squared_gap, of_gap_.low * of_gap_.low) > 0;
    return false;
  }

  Accuracy accuracy(const mpq_class& d) override {
    const RationalInterval length = without_radii(length_);
    const mpq_class ulp = ulp_at_root(length.low * length.low, format_);
    if (is_correctly_rounded(d) && (added_ == 0 || is_within(d, known(ulp / 2)))) return Accuracy::correctly_rounded;
    if (is_within(d, known(4 * ulp))) return Accuracy::ulps_4;
    if (is_within(d, known(16 * rounding_unit()))) return Accuracy::u_r_16;
    return is_within(d, length / 1'000'000) ? Accuracy::millionth : Accuracy::tolerance;
  }

  [[nodiscard]] bool open() const override { return open_; }

  void measure(const Claim& claim, Judgement& result) override {
    result.status = status_;
    result.signed_depth = outward(value_);
    if (!claim.overlap && claim.length) ask_for(positive_part(-value_));
    if (claim.length) measure_length(*claim.length, result);
    if (claim.direction) {
      separating_distance_ = separating_distance_of(*claim.direction);
      if (separating_distance_) result.separating_distance = outward(*separating_distance_);
      if (separating_distance_ && claim.overlap && status_ == Status::penetrating)
        result.relative_excess = least(quotient(*separating_distance_ - depth_, depth_));
      if (separating_distance_ && claim.length)
        result.inconsistency = least(known(claim.way()) - *separating_distance_);
    }
    if (claim.witness_a) result.witness_a_distance = outward(*(away_a_ = distance_of(*claim.witness_a, truth_.a)));
    if (claim.witness_b) result.witness_b_distance = outward(*(away_b_ = distance_of(*claim.witness_b, truth_.b)));
    for (const Point& contact : claim.contacts) {
      contacts_a_.push_back(distance_of(contact, truth_.a));
      contacts_b_.push_back(distance_of(contact, truth_.b));
      contact_a_ = greater(contact_a_.value_or(known(0)), contacts_a_.back());
      contact_b_ = greater(contact_b_.value_or(known(0)), contacts_b_.back());
    }
    if (contact_a_) result.contact_a_distance = outward(*contact_a_);
    if (contact_b_) result.contact_b_distance = outward(*contact_b_);
  }

  void conclude(Judgement& result) const override {
    if (left_) result.overlap_left = *left_;
  }

  [[nodiscard]] std::string depth() const override { return text(depth_); }
  [[nodiscard]] std::string distance() const override { return text(positive_part(-value_)); }
  [[nodiscard]] std::string length() const override { return text(length_); }
  [[nodiscard]] double off_by(const mpq_class& d) const override { return least(known(d) - length_); }
  [[nodiscard]] std::string left(const mpq_class&) const override {
    if (!separating_distance_) return "its direction does not lead out of the half-space";
    return left_ ? fmt::format("at least {:.4g} of overlap is left along its direction", *left_)
                 : "overlap is left along its direction";
  }
  [[nodiscard]] std::string across(const std::string& claimed) const override {
    if (!separating_distance_) return "its direction does not lead out of the half-space";
    if (has_halfspace())
      return fmt::format("the way out along its direction is {}, not {}", text(*separating_distance_), claimed);
    return fmt::format("the plane across its direction is at {}, not at {}", text(*separating_distance_), claimed);
  }
  [[nodiscard]] std::string gap(const std::string& claimed) const override {
    if (!separating_distance_) return "its direction does not lead out of the half-space";
    if (sgn(separating_distance_->low) > 0) return "no plane across its direction separates the bodies";
    return fmt::format("the gap across its direction is {}, not {}", text(-*separating_distance_), claimed);
  }
  [[nodiscard]] double away_a() const override { return least(*away_a_); }
  [[nodiscard]] double away_b() const override { return least(*away_b_); }
  [[nodiscard]] double contact_away_a() const override { return least(contact_away_a_.value()); }
  [[nodiscard]] double contact_away_b() const override { return least(contact_away_b_.value()); }

 private:
  // ---- allowances ----
  /// Returns the length in question less the radii that the subject added, if that is smaller:
  /// errors are relative to it.
  [[nodiscard]] RationalInterval without_radii(const RationalInterval& length) const {
    return added_ == 0 ? length : lesser(length, magnitude(value_ - known(added_)));
  }

  /// Returns the larger of the relative tolerance of a true length, and `fixed`.
  [[nodiscard]] RationalInterval allowed(const mpq_class& fixed, const RationalInterval& true_length) const {
    for (const mpq_class* part : {&tolerance_.relative, &tolerance_.absolute}) kernels::require_lowest_terms(*part);
    const mpq_class relative = std::max(mpq_class(0), tolerance_.relative),
                    absolute = std::max({mpq_class(0), mpq_class(tolerance_.absolute * asked_.extent), fixed});
    const RationalInterval length = without_radii(true_length);
    return greater({relative * length.low, relative * length.high}, known(absolute));
  }

  /// Makes `length` the length in question.
  void ask_for(const RationalInterval& length) {
    length_ = length;
    Sizes sizes = sizes_;
    if (has_halfspace()) {  // its witness point lies on a plane so far from the other body, and its depth counts in any
                            // direction
      sizes.farthest += length.high;
      sizes.reach += length.high;
    }
    farthest_ = asked_.farthest + (has_halfspace() ? without_radii(length).high : mpq_class(0));
    const Slack slack = rounding_slack(sizes, length.high * length.high, format_, tolerance_.ulps);
    of_length_ = allowed(slack.depth, length);
    of_direction_ = allowed(slack.direction, length);
    of_witness_ = allowed(slack.witness, length);
    of_gap_ = allowed(slack.gap, length);
  }

  /// Returns whether d - length, or length - d, exceeds the allowance for all values of both.
  bool above(const mpq_class& d, const RationalInterval& length, const RationalInterval& allowed) {
    return exceeds(known(d) - length, allowed);
  }
  bool below(const mpq_class& d, const RationalInterval& length, const RationalInterval& allowed) {
    return exceeds(length - known(d), allowed);
  }
  /// Returns the distance of the farthest contact that is off.
  std::optional<RationalInterval> farthest_off(const Claim& claim, const std::vector<RationalInterval>& distances) {
    std::optional<RationalInterval> farthest;
    for (std::size_t k = 0; k < distances.size(); ++k)
      if (below(claim.gap(k), distances[k], of_witness_))
        farthest = greater(farthest.value_or(distances[k]), distances[k]);
    return farthest;
  }
  bool exceeds(const RationalInterval& excess, const RationalInterval& allowed) {
    if (excess.low > allowed.high) return true;
    open_ = open_ || excess.high > allowed.low;
    return false;
  }

  // ---- the truth ----
  [[nodiscard]] bool has_halfspace() const { return shapes::is_halfspace(truth_.a) || shapes::is_halfspace(truth_.b); }

  [[nodiscard]] SignedDepth of(const Shape& a) const {
    SignedDepthOptions options;
    options.bits = bits_;
    return signed_depth(a, truth_.b, options);
  }

  [[nodiscard]] RationalInterval enclosed(const SignedDepth& depth) const {
    if (const Bounds* const bounds = depth.bounds()) return {bounds->low, bounds->high};
    return kernels::enclosed(*depth.exact(), 4 * bits_);
  }

  /// Returns h(u)/|u| plus the radii for two bounded bodies. Out of a half-space, returns the way
  /// along u, or nullopt if u leads into it.
  [[nodiscard]] std::optional<RationalInterval> separating_distance_of(const Vector& u) const {
    if (!has_halfspace())
      return shapes::support(truth_.b, point_of(u), 4 * bits_) + shapes::support(truth_.a, point_of(-u), 4 * bits_);
    const bool of_a = shapes::is_halfspace(truth_.a);
    const Point& n = std::get<HalfSpace>(of_a ? truth_.a.core : truth_.b.core).normal;
    const mpq_class along = of_a ? mpq_class(-dot(u, n)) : dot(u, n);
    if (sgn(along) <= 0) return std::nullopt;
    const mpq_class slant = dot(n, n) * mpq_class(dot(u, u)) / (along * along);
    const RationalInterval root = kernels::enclosed({0, slant}, 4 * bits_);
    return RationalInterval{value_.low * (sgn(value_.low) < 0 ? root.high : root.low),
                            value_.high * (sgn(value_.high) < 0 ? root.low : root.high)};
  }

  /// Returns whether the interiors meet after A has moved along u by `way` or slightly more.
  bool still_meet(const Vector& u, const mpq_class& way) {
    if (sgn(way) <= 0) return true;  // they meet before A moves
    const mpq_class factor = way / kernels::enclosed({0, mpq_class(dot(u, u))}, 4 * bits_).low;
    const std::optional<Status> after = of(translated(truth_.a, factor, u)).status();
    open_ = open_ || !after;
    return after == Status::penetrating;
  }

  /// Finds a lower bound, to within a thousandth, of the length along u up to which the interiors
  /// meet.
  void find_left(const Vector& u, const mpq_class& d, mpq_class low, mpq_class high) {
    constexpr int steps = 10;
    const bool was_open = open_;
    low = std::max(low, depth_.low);  // no way out is shorter than the depth
    for (int i = 0; i < steps; ++i) {
      mpq_class middle = (low + high) / 2;
      const double near = round_binary64(middle);  // a shorter number, if the interiors meet there
      if (std::isfinite(near) && low < exact_value(near) && exact_value(near) < high) middle = exact_value(near);
      (still_meet(u, middle) ? low : high) = middle;
    }
    open_ = was_open;
    left_ = round_binary64(low - d, Rounding::rd);
  }

  [[nodiscard]] RationalInterval distance_of(const Point& witness, const Shape& body) const {
    SignedDepthOptions options;
    options.bits = bits_;
    const std::array<Point, 1> points{witness};
    return positive_part(-enclosed(signed_depth(hull(points), body, options)));
  }

  // ---- the claimed length ----
  [[nodiscard]] mpq_class rounding_unit() const { return unit_roundoff(format_.points) * farthest_; }

  void measure_length(const mpq_class& d, Judgement& result) const {
    const RationalInterval error = known(d) - length_;
    const mpq_class u_r = rounding_unit();
    result.error = least(error);
    if (sgn(length_.low) > 0) result.error_ulps = least(error / ulp_at_root(length_.high * length_.high, format_));
    const RationalInterval length = without_radii(length_);
    if (sgn(length.low) > 0) result.error_relative = least(quotient(error, length));
    if (sgn(u_r) > 0) result.error_u_r = least(error / u_r);
  }

  /// Returns whether d is within the allowance of the length in question.
  bool is_within(const mpq_class& d, const RationalInterval& length) {
    const RationalInterval over = known(d) - length_;
    const mpq_class most = std::max(mpq_class(-over.low), over.high),
                    least = std::max({mpq_class(0), over.low, mpq_class(-over.high)});
    if (most <= length.low) return true;
    open_ = open_ || least <= length.high;
    return false;
  }

  bool is_correctly_rounded(const mpq_class& d) {
    const auto round = [&](const mpq_class& x) {
      const mpq_class there = scaled(x, format_.exponent);
      return format_.answers == Precision::binary64 ? round_binary64(there)
                                                    : static_cast<double>(round_binary32(there));
    };
    const double low = round(length_.low), high = round(length_.high);
    const mpq_class claimed = scaled(d, format_.exponent);
    if (low == high) return std::isfinite(low) && exact_value(low) == claimed;
    open_ = open_ ||
            (std::isfinite(low) && exact_value(low) <= claimed && (std::isinf(high) || claimed <= exact_value(high)));
    return false;
  }

  const ShapeTruth& truth_;
  NumberFormat format_;
  const Tolerance& tolerance_;
  unsigned bits_;
  std::optional<SignedDepth> closer_;
  std::optional<Status> status_;
  RationalInterval value_, depth_, length_;  // the signed depth, its positive part, the length in question
  mpq_class added_;                          // the sum of the subject's own radii
  Sizes sizes_, asked_;                      // asked_: without the subject's radii
  mpq_class farthest_;                       // of the given bodies, including a half-space's witness point
  RationalInterval classification_, of_length_, of_direction_, of_witness_, of_gap_;  // the allowances
  std::optional<RationalInterval> separating_distance_, away_a_, away_b_;
  std::optional<RationalInterval> contact_a_, contact_b_;  // the farthest of the contacts:
  std::vector<RationalInterval> contacts_a_, contacts_b_;
  std::optional<RationalInterval> contact_away_a_, contact_away_b_;  // the farthest of those that are off
  std::optional<double> left_;
  bool open_ = false;
};

}  // namespace

std::unique_ptr<Measures> measures_of(const ShapeTruth& truth, const NumberFormat& format, const Tolerance& tolerance,
                                      unsigned bits) {
  return std::make_unique<ShapeMeasures>(truth, format, tolerance, bits);
}

}  // namespace fathom::judging
