// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge/sentence.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fathom/numbers.hpp"
#include "kernels/number/irrational.hpp"
#include "kernels/number/rational.hpp"

namespace fathom::judging {
namespace {

std::string amount(double difference) { return fmt::format("{:.4g}", std::abs(difference)); }

class Teller {
 public:
  Teller(const Judgement& judgement, const Measures& truth, const Reply& reply, const Claim& mended, const NumberFormat& format,
         const Remarks& remarks)
      : judgement_(judgement), truth_(truth), reply_(reply), claim_(mended), format_(format), remarks_(remarks) {}

  [[nodiscard]] std::string all() const {
    if (judgement_.findings.empty() && judgement_.longer) return longer();
    if (judgement_.findings.empty()) return truth_.status() == Status::touching ? touching() : pass();
    std::string result;
    for (const Verdict finding : judgement_.findings) result += (result.empty() ? "" : "; ") + told(finding);
    return result;
  }

 private:
  [[nodiscard]] std::string shortest(double x) const {
    const bool narrow = format_.answers == Precision::binary32 && std::isfinite(x) && kernels::nearest_binary32(x) == x;
    return narrow ? fmt::format("{}", static_cast<float>(x)) : fmt::format("{}", x);  // in another unit it may be no binary32
  }
  [[nodiscard]] std::string depth() const { return truth_.depth(); }
  [[nodiscard]] std::string claimed() const { return shortest(kernels::nearest_binary64({*claim_.length, 0})); }
  [[nodiscard]] std::string apart() const {
    const std::string by = truth_.distance();
    return by.empty() ? "the bodies are apart" : "the bodies are apart by " + by;
  }
  [[nodiscard]] const char* length() const { return claim_.overlap ? "depth" : "distance"; }
  [[nodiscard]] std::string off(const char* way) const {
    return fmt::format("too {} by {}: {} is claimed, the {} is {}", way, amount(truth_.off_by(*claim_.length)), claimed(), length(),
                       truth_.length());
  }

  [[nodiscard]] std::string told(Verdict finding) const {
    switch (finding) {
      case Verdict::nan: return not_finite();
      case Verdict::false_separation:
        if (truth_.status() == Status::touching) return "said to be apart: the bodies touch, which it declares to be an overlap";
        return "said to be apart: the bodies overlap, the depth is " + depth();
      case Verdict::false_overlap:
        if (truth_.status() == Status::touching) return "said to overlap: the bodies touch, which it declares not to be an overlap";
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
      default: return std::string(name(finding));
    }
  }

  [[nodiscard]] std::string not_finite() const {
    if (const double claimed = *length_of(reply_); !std::isfinite(claimed)) return fmt::format("the {} is {}", length(), claimed);
    if (reply_.direction && !is_finite(*reply_.direction)) return "the direction is not finite";
    for (const auto* p : {&reply_.witness_a, &reply_.witness_b})
      if (*p && !is_finite(**p)) return "a witness point is not finite";
    return "a contact is not finite";
  }

  [[nodiscard]] std::string not_a_direction() const {
    if (sgn(*claim_.direction_length) == 0) return "the direction is zero";
    return fmt::format("the direction has length {}, where 1 is promised", root_binary64(*claim_.direction_length, Rounding::rn));
  }

  [[nodiscard]] std::string wrong_sign() const {
    std::string result;
    if (remarks_.length_sign) {
      const bool below = *length_of(reply_) > 0;  // the right one
      result = fmt::format("the {} has the wrong sign: {}{} is claimed, {}{}{} is right", length(), below ? "" : "-", claimed(),
                           claim_.overlap ? "by its conventions " : "", below ? "-" : "", truth_.length());
    }
    if (remarks_.direction_sign) result += std::string(result.empty() ? "" : "; ") + "the direction points the wrong way";
    return result;
  }

  [[nodiscard]] std::string inconsistent() const {
    std::string result = "inconsistent: ";
    if (remarks_.price) result += claim_.overlap ? truth_.across(claimed()) : truth_.gap(claimed());
    if (remarks_.deepest) {
      result += fmt::format("{}the depth of the deepest contact differs by {}", remarks_.price ? ", " : "",
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

  [[nodiscard]] std::string touching() const {
    return std::string("the bodies touch, and it says that they ") + (reply_.overlap ? "overlap" : "are apart") +
           ", which its conventions allow";
  }

  [[nodiscard]] std::string longer() const {
    const std::optional<double>& dearer = judgement_.dearer;
    return fmt::format("separating: {} is claimed, the price of its direction; the depth is {}{}", claimed(), depth(),
                       dearer && std::isfinite(*dearer) ? fmt::format(", the price is {:.4g} % more", 100 * *dearer) : "");
  }

  [[nodiscard]] std::string pass() const {
    if (!truth_.status())
      return std::string("undecided: the bounds of the truth leave open whether the bodies overlap, and it says that they ") +
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
};

}  // namespace

std::string sentence(const Judgement& judgement, const Measures& truth, const Reply& reply, const Claim& mended, const NumberFormat& format,
                     const Remarks& remarks) {
  return Teller(judgement, truth, reply, mended, format, remarks).all();
}

}  // namespace fathom::judging
