// SPDX-License-Identifier: GPL-3.0-or-later
// Judges one answer, point by point as on the page VERDICTS.md: the classification, the depth or
// distance, the direction, the witness points. Every comparison is exact; only shown numbers are
// rounded. [proofs/judge.md]
#include "fathom/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fathom/numbers.hpp"
#include "kernels/float_environment.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"
#include "verify/judge/claim.hpp"
#include "verify/judge/manifold.hpp"
#include "verify/judge/measures.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::judging {
namespace {

// ---- the judgement in one line of English ----

/// The reasons of findings that may have several.
struct Remarks {
  bool tolerated = false;                                  ///< the classification is wrong, within the tolerance
  bool length_sign = false, direction_sign = false;        ///< wrong, and corrected in the claim
  bool witness_a = false, witness_b = false, gap = false;  ///< off
  bool contact_a = false, contact_b = false;               ///< off
  bool separating_distance = false, deepest = false;       ///< differs from the claimed length
};

std::string amount(double difference) { return fmt::format("{:.4g}", std::abs(difference)); }

/// Writes the sentence of a judgement: findings one after another, each with its numbers; depths
/// and claims as shortest decimals, differences to four digits.
class Teller {
 public:
  Teller(const Judgement& judgement, const Measures& truth, const Reply& reply, const Claim& mended,
         const NumberFormat& format, const Remarks& remarks, const std::vector<ContactFault>& faults)
      : judgement_(judgement),
        truth_(truth),
        reply_(reply),
        claim_(mended),
        format_(format),
        remarks_(remarks),
        faults_(faults) {}

  [[nodiscard]] std::string all() const {
    if (judgement_.findings.empty() && judgement_.excess_allowed) return separating();
    if (judgement_.findings.empty()) return truth_.status() == Status::touching ? touching() : pass();
    std::string result;
    for (const Verdict finding : judgement_.findings) result += (result.empty() ? "" : "; ") + told(finding);
    return result;
  }

 private:
  [[nodiscard]] std::string shortest(double x) const {
    const bool narrow = format_.answers == Precision::binary32 && std::isfinite(x) && kernels::nearest_binary32(x) == x;
    return narrow ? fmt::format("{}", static_cast<float>(x))
                  : fmt::format("{}", x);  // a number in another unit may not be a binary32
  }
  [[nodiscard]] std::string depth() const { return truth_.depth(); }
  [[nodiscard]] std::string claimed() const { return shortest(kernels::nearest_binary64({*claim_.length, 0})); }
  [[nodiscard]] std::string apart() const {
    const std::string by = truth_.distance();
    return by.empty() ? "the bodies are apart" : "the bodies are apart by " + by;
  }
  [[nodiscard]] const char* length() const { return claim_.overlap ? "depth" : "distance"; }
  [[nodiscard]] std::string off(const char* way) const {
    return fmt::format("too {} by {}: {} is claimed, the {} is {}", way, amount(truth_.off_by(*claim_.length)),
                       claimed(), length(), truth_.length());
  }

  [[nodiscard]] std::string told(Verdict finding) const {
    switch (finding) {
      case Verdict::nan: return not_finite();
      case Verdict::false_separation:
        if (truth_.status() == Status::touching)
          return "said to be apart: the bodies touch, which it declares to be an overlap";
        return "said to be apart: the bodies overlap, the depth is " + depth();
      case Verdict::false_overlap:
        if (truth_.status() == Status::touching)
          return "said to overlap: the bodies touch, which it declares not to be an overlap";
        return "said to overlap: " + apart();
      case Verdict::not_a_direction: return not_a_direction();
      case Verdict::wrong_sign: return wrong_sign();
      case Verdict::too_deep: return off("deep");
      case Verdict::too_shallow: return off("shallow") + truth_.times(*claim_.length);
      case Verdict::too_far: return off("far");
      case Verdict::too_near: return off("near");
      case Verdict::not_separating: return "not separating: " + truth_.left(*claim_.length);
      case Verdict::inconsistent: return inconsistent();
      case Verdict::witness_off: return witness_off();
      case Verdict::contact_outside:
      case Verdict::contact_too_deep:
      case Verdict::contact_too_shallow:
      case Verdict::misses_extent:
      case Verdict::tips: return of_contacts(finding);
      default: return std::string(name(finding));
    }
  }

  [[nodiscard]] std::string not_finite() const {
    if (const double claimed = *length_of(reply_); !std::isfinite(claimed))
      return fmt::format("the {} is {}", length(), claimed);
    if (reply_.direction && !is_finite(*reply_.direction)) return "the direction is not finite";
    for (const auto* p : {&reply_.witness_a, &reply_.witness_b})
      if (*p && !is_finite(**p)) return "a witness point is not finite";
    return "a contact is not finite";
  }

  [[nodiscard]] std::string not_a_direction() const {
    if (sgn(*claim_.direction_length) == 0) return "the direction is zero";
    return fmt::format("the direction has length {}, where 1 is promised",
                       root_binary64(*claim_.direction_length, Rounding::rn));
  }

  [[nodiscard]] std::string wrong_sign() const {
    std::string result;
    if (remarks_.length_sign) {
      const bool below = *length_of(reply_) > 0;  // the right one
      result = fmt::format("the {} has the wrong sign: {}{} is claimed, {}{}{} is right", length(), below ? "" : "-",
                           claimed(), claim_.overlap ? "by its conventions " : "", below ? "-" : "", truth_.length());
    }
    if (remarks_.direction_sign)
      result += std::string(result.empty() ? "" : "; ") + "the direction points the wrong way";
    return result;
  }

  [[nodiscard]] std::string inconsistent() const {
    std::string result = "inconsistent: ";
    if (remarks_.separating_distance) result += claim_.overlap ? truth_.across(claimed()) : truth_.gap(claimed());
    if (remarks_.deepest) {
      result +=
          fmt::format("{}the depth of the deepest contact differs by {}", remarks_.separating_distance ? ", " : "",
                      amount(kernels::nearest_binary64({*deepest_contact(claim_), 0})));
    }
    return result;
  }

  [[nodiscard]] std::string witness_off() const {
    std::string result;
    const auto add = [&result](std::string text) { result += (result.empty() ? "" : "; ") + std::move(text); };
    if (remarks_.witness_a) add(fmt::format("the witness point of A is {} away from it", amount(truth_.away_a())));
    if (remarks_.witness_b) add(fmt::format("the witness point of B is {} away from it", amount(truth_.away_b())));
    if (remarks_.contact_a) add(fmt::format("a contact is {} away from A", amount(truth_.contact_away_a())));
    if (remarks_.contact_b) add(fmt::format("a contact is {} away from B", amount(truth_.contact_away_b())));
    if (remarks_.gap && !remarks_.length_sign && !remarks_.direction_sign) {
      add(fmt::format("the witness points miss the {} by {}", claim_.overlap ? "translation" : "distance",
                      amount(*judgement_.witness_gap)));
    } else if (remarks_.gap) {
      add(std::string("the witness points miss the ") + (claim_.overlap ? "translation" : "distance"));
    }
    return result;
  }

  /// Describes the first contact with this finding, and counts the others.
  [[nodiscard]] std::string of_contacts(Verdict finding) const {
    const auto others = std::ranges::count(faults_, finding, &ContactFault::finding) - 1;
    const std::string& first = std::ranges::find(faults_, finding, &ContactFault::finding)->sentence;
    return others > 0 ? fmt::format("{}, and {} more {} so", first, others, others == 1 ? "is" : "are") : first;
  }

  [[nodiscard]] std::string touching() const {
    return std::string("the bodies touch, and it says that they ") + (reply_.overlap ? "overlap" : "are apart") +
           ", which its conventions allow";
  }

  [[nodiscard]] std::string separating() const {
    const std::optional<double>& excess = judgement_.relative_excess;
    return fmt::format(
        "separating: {} is claimed, the separating distance of its direction; the depth is {}{}", claimed(), depth(),
        excess && std::isfinite(*excess) ? fmt::format(", that distance is {:.4g} % more", 100 * *excess) : "");
  }

  [[nodiscard]] std::string pass() const {
    if (!truth_.status())
      return std::string(
                 "undecided: the bounds of the truth leave open whether the bodies overlap, and it says that they ") +
             (reply_.overlap ? "do" : "do not");
    if (remarks_.tolerated) {
      if (truth_.status() == Status::disjoint) return "within the tolerance: said to overlap, " + apart();
      return "within the tolerance: said to be apart, the depth is " + depth();
    }
    if (!claim_.length) return "right: " + (reply_.overlap ? "the bodies overlap" : apart());
    const Accuracy accuracy = *judgement_.accuracy;
    const std::string how = accuracy == Accuracy::correctly_rounded ? "correctly rounded"
                            : accuracy == Accuracy::tolerance       ? "within the tolerance"
                                                                    : "within " + std::string(name(accuracy));
    return fmt::format("right: {} is claimed, the {} is {} ({})", claimed(), length(), truth_.length(), how);
  }

  const Judgement& judgement_;
  const Measures& truth_;
  const Reply& reply_;
  const Claim& claim_;
  NumberFormat format_;
  const Remarks& remarks_;
  const std::vector<ContactFault>& faults_;
};

// ---- the judge ----

class Judge {
 public:
  /// `polytopes`: the truth, if the measures are those of polytopes; else null.
  Judge(Measures& truth, const Truth* polytopes, const Reply& reply, const Conventions& conventions,
        const NumberFormat& format, const Tolerance& tolerance)
      : truth_(truth),
        polytopes_(polytopes),
        reply_(reply),
        conventions_(conventions),
        format_(format),
        tolerance_(tolerance),
        claim_(exact_claim(reply, conventions, format.exponent)) {}

  Judgement run() {
    truth_.measure(claim_, result_);
    gap_ = squared_gap();
    if (gap_) result_.witness_gap = kernels::nearest_root_binary64(*gap_);
    if (const std::optional<mpq_class> off = deepest_contact(claim_))
      result_.deepest = kernels::nearest_binary64({*off, 0});
    classification();
    if (length_of(reply_)) {  // else only the classification is judged
      if (!claim_.finite) found(Verdict::nan);
      length();
      direction();
      if (deep_) too_deep();
      witnesses();
      contacts();
    }
    truth_.conclude(result_);
    conclude();
    result_.sentence = Teller(result_, truth_, reply_, claim_, format_, remarks_, faults_).all();
    return std::move(result_);
  }
  /// Returns the faults of contacts of polytopes, after a run.
  std::vector<ContactFault>& faults() { return faults_; }

 private:
  void found(Verdict verdict) { result_.findings.push_back(verdict); }

  /// Returns |(b - a) - w u / |u||^2, where w is the way of A, for the claim before corrections;
  /// without a claimed direction, (|b - a| - length)^2.
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

  /// Corrects a wrong sign before the rest is judged.
  void length() {
    if (!claim_.length) return;
    mpq_class& d = *claim_.length;
    if (truth_.is_negative(d) && !truth_.too_long(-d) && !truth_.too_short(-d)) {
      remarks_.length_sign = true;
      found(Verdict::wrong_sign);
      d = -d;
      for (std::optional<mpq_class>& depth : claim_.contact_depths)
        if (depth) *depth = -*depth;
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
      if (!truth_.is_inconsistent(-u, claim_.way())) {  // then -u separates too: exit distance <= separating distance
        remarks_.direction_sign = true;
        found(Verdict::wrong_sign);
        u = -u;
        return;
      }
      remarks_.separating_distance = !(overlaps && truth_.is_one_question());
      if (remarks_.separating_distance) found(Verdict::inconsistent);
    }
    if (overlaps) found(Verdict::not_separating);
  }

  /// Decides whether a depth that is too long is allowed by the policy: as the separating distance
  /// of its own direction.
  void too_deep() {
    result_.excess_allowed =
        claim_.direction && !truth_.is_inconsistent(*claim_.direction, *claim_.length) && allows(*claim_.direction);
    if (!result_.excess_allowed) found(Verdict::too_deep);
  }

  [[nodiscard]] bool allows(const Vector& u) {
    using Kind = Policy::Kind;
    const Policy& policy = tolerance_.policy;
    if (policy.kind == Kind::within) return !truth_.exceeds_depth(u, 1 + policy.most);
    return policy.kind == Kind::separating ||
           (policy.kind == Kind::declared && conventions_.claims == Conventions::Claims::separating);
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
    if (remarks_.length_sign || remarks_.direction_sign) gap_ = squared_gap();
    if (gap_) remarks_.gap = truth_.misses(*gap_);
    if (remarks_.witness_a || remarks_.witness_b || remarks_.gap) found(Verdict::witness_off);
  }

  void contacts() {
    manifold();
    remarks_.contact_a = truth_.is_contact_off_a(claim_);
    remarks_.contact_b = truth_.is_contact_off_b(claim_);
    if (remarks_.contact_a || remarks_.contact_b) found(Verdict::witness_off);
    const std::optional<mpq_class> off = deepest_contact(claim_);
    remarks_.deepest = off && !result_.excess_allowed && truth_.is_off_length(*off);
    if (remarks_.deepest) found(Verdict::inconsistent);
  }

  /// Judges all contacts together, unless the classification or a sign is wrong.
  void manifold() {
    const auto is_first = [](Verdict finding) { return finding <= Verdict::wrong_sign; };
    if (!polytopes_ || claim_.contacts.empty() || std::ranges::any_of(result_.findings, is_first)) return;
    const ContactJudge judge(*polytopes_, claim_, *truth_.allowances(), conventions_.manifold, format_.exponent,
                             tolerance_.patch_slack);
    faults_ = judge.faults();
    if (const std::optional<MeasuredExtent> extent = judge.measured()) {
      result_.extent_missed_squared = extent->missed_squared;
      result_.extent_covered_squared = extent->covered_squared;
    }
    // A longer translation that is allowed has a patch of its own, and exceeds every local depth.
    if (result_.excess_allowed)
      std::erase_if(faults_, [&](const ContactFault& fault) {
        return !fault.contact || (fault.finding == Verdict::contact_too_deep && !claim_.contact_depths[*fault.contact]);
      });
    for (const ContactFault& fault : faults_) {
      found(fault.finding);
      if (fault.finding == Verdict::contact_outside) claim_.outside.insert(*fault.contact);
    }
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
    else if (claim_.length && !result_.excess_allowed) result_.accuracy = truth_.accuracy(*claim_.length);
  }

  Measures& truth_;
  const Truth* polytopes_;
  const Reply& reply_;
  const Conventions& conventions_;
  NumberFormat format_;
  const Tolerance& tolerance_;
  Claim claim_;
  std::optional<Surd> gap_;  // squared_gap
  Remarks remarks_;
  bool deep_ = false;
  std::vector<ContactFault> faults_;
  Judgement result_;
};

// ---- the derivative ----

Body body_of(const GivenPoints& points) { return {points}; }
Body body_of(const Shape& shape) { return {{}, shape}; }
Body body_of(const Pieces& pieces) { return {.points = {}, .pieces = std::make_shared<const Pieces>(pieces)}; }

/// A reply, and the parameters of judging it.
struct Question {
  const Reply& reply;
  const Conventions& conventions;
  const NumberFormat& format;
  const Tolerance& tolerance;
  const std::optional<Motion>& motion;
  Monitor* monitor;
};

/// Returns the judgement with that on the derivative, if one is claimed for a motion.
template <class AnyKnown>
Judgement with_derivative(Judgement judgement, const AnyKnown& truth, const Question& asked) {
  if (!asked.motion || !asked.reply.derivative) return judgement;
  const DerivativeJudgement& found = judgement.derivative.emplace(
      judged_derivative(body_of(truth.a), body_of(truth.b), Answer{truth.depth}, *asked.motion, asked.reply,
                        asked.conventions, asked.format, asked.tolerance, truth.dimension, asked.monitor));
  if (!found.sentence.empty())
    add_finding(judgement, std::isfinite(*asked.reply.derivative) ? Verdict::wrong_derivative : Verdict::nan,
                found.sentence);
  return judgement;
}

}  // namespace

void add_finding(Judgement& judgement, Verdict finding, const std::string& sentence) {
  judgement.sentence = passes(judgement.verdict) ? sentence : judgement.sentence + "; " + sentence;
  judgement.accuracy.reset();
  std::vector<Verdict>& all = judgement.findings;
  const auto place = std::ranges::lower_bound(all, finding);
  if (place == all.end() || *place != finding) all.insert(place, finding);
  judgement.verdict = all.front();
}

Judgement judged(const Truth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                 const Tolerance& tolerance, const std::optional<Motion>& motion, Monitor* monitor,
                 std::vector<ContactFault>* faults) {
  const kernels::DefaultFloatEnvironment environment;
  const std::unique_ptr<Measures> measures = measures_of(truth, format, tolerance);
  Judge judge(*measures, &truth, reply, conventions, format, tolerance);
  Judgement judgement = judge.run();
  if (faults) *faults = std::move(judge.faults());
  return with_derivative(std::move(judgement), truth, {reply, conventions, format, tolerance, motion, monitor});
}

}  // namespace fathom::judging

namespace fathom {

Judgement judge(const Truth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                const Tolerance& tolerance, const std::optional<Motion>& motion, Monitor* monitor) {
  return judging::judged(truth, reply, conventions, format, tolerance, motion, monitor, nullptr);
}

Judgement judge(const ShapeTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                const Tolerance& tolerance, const std::optional<Motion>& motion, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  for (unsigned bits = judging::usual_bits;; bits *= 2) {
    const std::unique_ptr<judging::Measures> measures = judging::measures_of(truth, format, tolerance, bits);
    Judgement judgement = judging::Judge(*measures, nullptr, reply, conventions, format, tolerance).run();
    if (!measures->open() || bits >= judging::most_bits)
      return judging::with_derivative(std::move(judgement), truth,
                                      {reply, conventions, format, tolerance, motion, monitor});
  }
}

Judgement judge(const UnionTruth& truth, const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                const Tolerance& tolerance, const std::optional<Motion>& motion, Monitor* monitor) {
  const kernels::DefaultFloatEnvironment environment;
  const std::unique_ptr<judging::Measures> measures = judging::measures_of(truth, format, tolerance, monitor);
  return judging::with_derivative(judging::Judge(*measures, nullptr, reply, conventions, format, tolerance).run(),
                                  truth, {reply, conventions, format, tolerance, motion, monitor});
}

}  // namespace fathom
