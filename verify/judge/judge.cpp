// SPDX-License-Identifier: GPL-3.0-or-later
// One answer, point by point as on the page VERDICTS.md: the classification, the depth, the direction, the witness points. Every
// comparison is exact; only what is shown is rounded.                                                      [proofs/judge.md]
#include "fathom/judge.hpp"

#include <algorithm>

#include "kernels/float_environment.hpp"
#include "verify/judge/allowance.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/scene.hpp"
#include "verify/judge/sentence.hpp"

namespace fathom::judging {
namespace {

class Judge {
 public:
  Judge(const Truth& truth, const Reply& reply, const Conventions& conventions, Precision precision, const Tolerance& tolerance)
      : truth_(truth),
        depth_(truth.depth),
        reply_(reply),
        conventions_(conventions),
        precision_(precision),
        tolerance_(tolerance),
        claim_(exact_claim(reply, conventions)),
        scene_(truth),
        allowed_(scene_.sizes(), truth.depth.squared(), precision, tolerance) {}

  Judgement run() {
    result_.status = depth_.status();
    result_.depth_squared = depth_.squared();
    if (depth_.distance()) result_.distance_squared = depth_.distance()->squared;
    measure();
    classification();
    if (claim_.overlap && reply_.depth) {  // without a depth, no more than the classification is judged
      if (!claim_.finite) found(Verdict::nan);
      depth();
      direction();
      witnesses();
    }
    conclude();
    result_.sentence = sentence(result_, depth_, reply_, claim_, precision_, remarks_);
    return std::move(result_);
  }

 private:
  void found(Verdict verdict) { result_.findings.push_back(verdict); }

  /// u R.
  [[nodiscard]] mpq_class rounding_unit() const { return unit_roundoff(precision_) * scene_.sizes().farthest; }

  /// The residuals, of the claim as it stands.
  void measure() {
    if (claim_.depth) {
      const mpq_class &d = *claim_.depth, &s = depth_.squared(), ulp = ulp_at_root(s, precision_), u_r = rounding_unit();
      result_.error = kernels::nearest_binary64({d, -s});
      if (sgn(s) > 0) {
        result_.error_ulps = kernels::nearest_binary64({d / ulp, -s / (ulp * ulp)});
        result_.error_relative = kernels::nearest_binary64({-1, d * abs(d) / s});
      }
      if (sgn(u_r) > 0) result_.error_u_r = kernels::nearest_binary64({d / u_r, -s / (u_r * u_r)});
    }
    if (claim_.direction) {
      result_.price_squared = scene_.price(*claim_.direction);
      result_.travel_squared = scene_.travel(*claim_.direction);
      if (claim_.depth) {
        result_.inconsistency = kernels::nearest_binary64({*claim_.depth, -*result_.price_squared});
        const Surd left{-*claim_.depth, *result_.travel_squared};
        if (depth_.status() == Status::penetrating && sign(left) > 0) result_.overlap_left = kernels::nearest_binary64(left);
      }
    }
    if (claim_.witness_a) result_.witness_a_squared = squared_distance(*claim_.witness_a, truth_.a);
    if (claim_.witness_b) result_.witness_b_squared = squared_distance(*claim_.witness_b, truth_.b);
    if (const std::optional<Surd> gap = squared_gap()) result_.witness_gap = kernels::nearest_root_binary64(*gap);
  }

  /// |(b - a) - d u / |u||^2 for the claim as it stands; where no direction is claimed, (|b - a| - d)^2.
  [[nodiscard]] std::optional<Surd> squared_gap() const {
    if (!claim_.witness_a || !claim_.witness_b || !claim_.depth) return std::nullopt;
    const Point &a = *claim_.witness_a, &b = *claim_.witness_b;
    const mpq_class x = b.x - a.x, y = b.y - a.y, z = b.z - a.z, d = *claim_.depth;
    const mpq_class apart = x * x + y * y + z * z;
    if (!reply_.direction) return Surd{apart + d * d, -4 * d * abs(d) * apart};
    if (!claim_.direction) return std::nullopt;
    const Vector& u = *claim_.direction;
    const mpq_class along = d * (x * u.x + y * u.y + z * u.z);
    return Surd{apart + d * d, -4 * along * abs(along) / dot(u, u)};
  }

  void classification() {
    using Touching = Conventions::Touching;
    if (depth_.status() == Status::penetrating && !claim_.overlap) {
      if (allowed_.classification.negligible(depth_.squared())) remarks_.tolerated = true;
      else found(Verdict::false_separation);
    }
    if (depth_.status() == Status::disjoint && claim_.overlap) {
      const bool near = depth_.distance() && allowed_.classification.negligible(depth_.distance()->squared);
      if (near && !(claim_.depth && allowed_.classification.above(*claim_.depth, 0))) remarks_.tolerated = true;
      else found(Verdict::false_overlap);
    }
    if (depth_.status() == Status::touching) {
      if (claim_.overlap && conventions_.touching == Touching::separate) found(Verdict::false_overlap);
      if (!claim_.overlap && conventions_.touching == Touching::overlap) found(Verdict::false_separation);
    }
  }

  /// Mends a wrong sign before the rest is judged.
  void depth() {
    if (!claim_.depth) return;
    mpq_class& d = *claim_.depth;
    if (allowed_.depth.below(d, 0) && !allowed_.depth.off(-d, depth_.squared())) {
      remarks_.depth_sign = true;
      found(Verdict::wrong_sign);
      d = -d;
    }
    if (allowed_.depth.above(d, depth_.squared())) found(Verdict::too_deep);
    if (allowed_.depth.below(d, depth_.squared())) found(Verdict::too_shallow);
  }

  void direction() {
    if (claim_.direction_length && !is_direction(*claim_.direction_length)) found(Verdict::not_a_direction);
    if (!claim_.direction || !claim_.depth) return;
    Vector& u = *claim_.direction;
    bool consistent = !allowed_.direction.off(*claim_.depth, *result_.price_squared), separates = separates_by(*result_.travel_squared);
    if (!consistent &&
        !allowed_.direction.off(*claim_.depth, scene_.price(-u))) {  // the travel is no more than the price: -u separates too
      remarks_.direction_sign = consistent = separates = true;
      found(Verdict::wrong_sign);
      u = -u;
    }
    if (!separates) found(Verdict::not_separating);
    if (!consistent) found(Verdict::inconsistent);
  }

  [[nodiscard]] bool is_direction(const mpq_class& square) const {
    if (sgn(square) == 0) return false;
    if (!conventions_.unit) return true;
    const mpq_class u = unit_roundoff(precision_),
                    t = std::max({tolerance_.relative, mpq_class(16 * u), mpq_class(2 * u * tolerance_.ulps)});
    return sign({-1 - t, square}) <= 0 && sign({t - 1, square}) >= 0;
  }

  /// Whether the claimed depth is no less than that way, except for the tolerance; or there is no way to go.
  [[nodiscard]] bool separates_by(const mpq_class& travel) const {
    return depth_.status() != Status::penetrating || !allowed_.direction.below(*claim_.depth, travel);
  }

  void witnesses() {
    const auto off = [&](const std::optional<mpq_class>& squared) { return squared && !allowed_.witness.negligible(*squared); };
    remarks_.witness_a = off(result_.witness_a_squared);
    remarks_.witness_b = off(result_.witness_b_squared);
    if (const std::optional<Surd> gap = squared_gap()) remarks_.gap = !allowed_.gap.negligible(*gap);
    if (remarks_.witness_a || remarks_.witness_b || remarks_.gap) found(Verdict::witness_off);
  }

  void conclude() {
    std::vector<Verdict>& all = result_.findings;
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (!all.empty()) {
      result_.verdict = all.front();
      return;
    }
    result_.verdict = depth_.status() == Status::touching ? Verdict::touching_by_convention : Verdict::pass;
    if (remarks_.tolerated) result_.accuracy = Accuracy::tolerance;
    else if (claim_.depth) result_.accuracy = accuracy_of(*claim_.depth, depth_.squared(), rounding_unit(), precision_);
  }

  const Truth& truth_;
  const Depth& depth_;
  const Reply& reply_;
  const Conventions& conventions_;
  Precision precision_;
  const Tolerance& tolerance_;
  Claim claim_;
  Scene scene_;
  Allowances allowed_;
  Remarks remarks_;
  Judgement result_;
};

}  // namespace

}  // namespace fathom::judging

namespace fathom {

Judgement judge(const Truth& truth, const Reply& reply, const Conventions& conventions, Precision precision, const Tolerance& tolerance) {
  const kernels::DefaultFloatEnvironment environment;
  return judging::Judge(truth, reply, conventions, precision, tolerance).run();
}

}  // namespace fathom
