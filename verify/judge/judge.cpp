// SPDX-License-Identifier: GPL-3.0-or-later
// One answer, point by point as on the page VERDICTS.md: the classification, the depth or distance, the direction, the witness points.
// Every comparison is exact; only what is shown is rounded.                                                [proofs/judge.md]
#include "fathom/judge.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "kernels/float_environment.hpp"
#include "verify/judge/allowance.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/sentence.hpp"

namespace fathom::judging {
namespace {

class Judge {
 public:
  Judge(Measures& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format, const Tolerance& tolerance)
      : truth_(truth),
        reply_(reply),
        conventions_(conventions),
        format_(format),
        tolerance_(tolerance),
        claim_(exact_claim(reply, conventions, format.exponent)) {}

  Judgement run() {
    truth_.measure(claim_, result_);
    if (const std::optional<Surd> gap = squared_gap()) result_.witness_gap = kernels::nearest_root_binary64(*gap);
    if (const std::optional<mpq_class> off = deepest_contact(claim_)) result_.deepest = kernels::nearest_binary64({*off, 0});
    classification();
    if (length_of(reply_)) {  // without one, no more than the classification is judged
      if (!claim_.finite) found(Verdict::nan);
      length();
      direction();
      if (deep_) too_deep();
      witnesses();
      contacts();
    }
    truth_.conclude(result_);
    conclude();
    result_.sentence = sentence(result_, truth_, reply_, claim_, format_, remarks_);
    return std::move(result_);
  }

 private:
  void found(Verdict verdict) { result_.findings.push_back(verdict); }

  /// |(b - a) - w u / |u||^2, where w is the way of A, for the claim as it stands; where no direction is claimed, (|b - a| - length)^2.
  [[nodiscard]] std::optional<Surd> squared_gap() const {
    if (!claim_.witness_a || !claim_.witness_b || !claim_.length) return std::nullopt;
    const Point &a = *claim_.witness_a, &b = *claim_.witness_b;
    const mpq_class x = b.x - a.x, y = b.y - a.y, z = b.z - a.z, d = *claim_.length;
    const mpq_class apart = x * x + y * y + z * z;
    if (!reply_.direction) return Surd{apart + d * d, -4 * d * abs(d) * apart};
    if (!claim_.direction) return std::nullopt;
    const Vector& u = *claim_.direction;
    const mpq_class along = claim_.way() * (x * u.x + y * u.y + z * u.z);
    return Surd{apart + d * d, -4 * along * abs(along) / dot(u, u)};
  }

  void classification() {
    using Touching = Conventions::Touching;
    const std::optional<Status> status = truth_.status();
    if (status == Status::penetrating && !claim_.overlap) {
      if (truth_.is_deep()) found(Verdict::false_separation);
      else remarks_.tolerated = true;
    }
    if (status == Status::disjoint && claim_.overlap) {
      if (truth_.is_far() || (claim_.length && truth_.claims_depth(*claim_.length))) found(Verdict::false_overlap);
      else remarks_.tolerated = true;
    }
    if (status == Status::touching) {
      if (claim_.overlap && conventions_.touching == Touching::separate) found(Verdict::false_overlap);
      if (!claim_.overlap && conventions_.touching == Touching::overlap) found(Verdict::false_separation);
    }
    if (!status) remarks_.tolerated = true;
  }

  /// Mends a wrong sign before the rest is judged.
  void length() {
    if (!claim_.length) return;
    mpq_class& d = *claim_.length;
    if (truth_.is_negative(d) && !truth_.too_long(-d) && !truth_.too_short(-d)) {
      remarks_.length_sign = true;
      found(Verdict::wrong_sign);
      d = -d;
      for (mpq_class& depth : claim_.contact_depths) depth = -depth;
    }
    if (truth_.too_long(d)) {
      deep_ = claim_.overlap;
      if (!deep_) found(Verdict::too_far);
    }
    if (truth_.too_short(d)) found(claim_.overlap ? Verdict::too_shallow : Verdict::too_near);
  }

  void direction() {
    if (claim_.direction_length && !is_direction(*claim_.direction_length)) found(Verdict::not_a_direction);
    if (!claim_.direction || !claim_.length) return;
    Vector& u = *claim_.direction;
    const bool overlaps = claim_.overlap && truth_.is_not_separating(u, *claim_.length);
    if (truth_.is_inconsistent(u, claim_.way())) {
      if (!truth_.is_inconsistent(-u, claim_.way())) {  // the travel is no more than the price: -u separates too
        remarks_.direction_sign = true;
        found(Verdict::wrong_sign);
        u = -u;
        return;
      }
      remarks_.price = !(overlaps && truth_.is_one_question());
      if (remarks_.price) found(Verdict::inconsistent);
    }
    if (overlaps) found(Verdict::not_separating);
  }

  /// A depth is as deep as the policy allows if it is the price of its own direction.
  void too_deep() {
    result_.longer = claim_.direction && !truth_.is_inconsistent(*claim_.direction, *claim_.length) && allows(*claim_.direction);
    if (!result_.longer) found(Verdict::too_deep);
  }

  [[nodiscard]] bool allows(const Vector& u) {
    using Kind = Policy::Kind;
    const Policy& policy = tolerance_.policy;
    if (policy.kind == Kind::within) return !truth_.is_dearer(u, 1 + policy.most);
    return policy.kind == Kind::separating || (policy.kind == Kind::declared && conventions_.claims == Conventions::Claims::separating);
  }

  [[nodiscard]] bool is_direction(const mpq_class& square) const {
    if (sgn(square) == 0) return false;
    if (!conventions_.unit) return true;
    const mpq_class u = unit_roundoff(format_.answers),
                    t = std::max({tolerance_.relative, mpq_class(16 * u), mpq_class(2 * u * tolerance_.ulps)});
    return sign({-1 - t, square}) <= 0 && sign({t - 1, square}) >= 0;
  }

  void witnesses() {
    remarks_.witness_a = truth_.is_off_a();
    remarks_.witness_b = truth_.is_off_b();
    if (const std::optional<Surd> gap = squared_gap()) remarks_.gap = truth_.misses(*gap);
    if (remarks_.witness_a || remarks_.witness_b || remarks_.gap) found(Verdict::witness_off);
  }

  void contacts() {
    remarks_.contact_a = truth_.is_contact_off_a();
    remarks_.contact_b = truth_.is_contact_off_b();
    if (remarks_.contact_a || remarks_.contact_b) found(Verdict::witness_off);
    const std::optional<mpq_class> off = deepest_contact(claim_);
    remarks_.deepest = off && truth_.is_off_length(*off);
    if (remarks_.deepest) found(Verdict::inconsistent);
  }

  void conclude() {
    std::vector<Verdict>& all = result_.findings;
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (!all.empty()) {
      result_.verdict = all.front();
      return;
    }
    result_.verdict = truth_.status() == Status::touching ? Verdict::touching_by_convention : Verdict::pass;
    if (remarks_.tolerated) result_.accuracy = Accuracy::tolerance;
    else if (claim_.length && !result_.longer) result_.accuracy = truth_.accuracy(*claim_.length);
  }

  Measures& truth_;
  const Reply& reply_;
  const Conventions& conventions_;
  NumberFormat format_;
  const Tolerance& tolerance_;
  Claim claim_;
  Remarks remarks_;
  bool deep_ = false;
  Judgement result_;
};

}  // namespace

}  // namespace fathom::judging

namespace fathom {

Judgement judge(const Truth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                const Tolerance& tolerance) {
  const kernels::DefaultFloatEnvironment environment;
  const std::unique_ptr<judging::Measures> measures = judging::measures_of(truth, format, tolerance);
  return judging::Judge(*measures, reply, conventions, format, tolerance).run();
}

Judgement judge(const ShapeTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                const Tolerance& tolerance) {
  const kernels::DefaultFloatEnvironment environment;
  for (unsigned bits = judging::usual_bits;; bits *= 2) {
    const std::unique_ptr<judging::Measures> measures = judging::measures_of(truth, format, tolerance, bits);
    Judgement judgement = judging::Judge(*measures, reply, conventions, format, tolerance).run();
    if (!measures->open() || bits >= judging::most_bits) return judgement;
  }
}

Judgement judge(const UnionTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                const Tolerance& tolerance, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  const std::unique_ptr<judging::Measures> measures = judging::measures_of(truth, format, tolerance, monitor);
  return judging::Judge(*measures, reply, conventions, format, tolerance).run();
}

}  // namespace fathom
