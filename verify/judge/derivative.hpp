// SPDX-License-Identifier: GPL-3.0-or-later
// A claimed derivative of the signed depth, judged: the exact one-sided rate at which the depth
// grows as two bodies begin to move, and what a wrong claim is instead.
//                                           [VERDICTS.md, "wrong-derivative"; proofs/patch.md]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <vector>

#include "fathom/judge.hpp"
#include "fathom/motion.hpp"
#include "verify/judge/truth.hpp"

namespace fathom::judging {

/// One claim beside the truth.
struct DerivativeJudgement {
  double claimed = 0;                ///< in the unit of the case
  std::optional<mpq_class> squared;  ///< of the true rate, negative if that is; nullopt if it is left out
  std::string left_out;              ///< then why: the word of LeftOut
  std::vector<std::string> kinks;    ///< why there is no gradient: the words of Kink; of unions not told
  std::optional<double> error;       ///< the claimed rate less the true one, correctly rounded
  std::string sentence;              ///< what is wrong with the claim; empty if nothing is
};

/// Judges the claim of an answer about the bodies, whose truth is known, in the subject's unit:
/// wrong by more than the tolerance times the largest speed of a point is wrong. The reply is
/// looked at to say what a wrong claim is instead. Throws Interrupted.
DerivativeJudgement judged_derivative(const Body& a, const Body& b, const AnyTruth& truth, const Motion& motion,
                                      double claimed, const Reply& reply, const Conventions& conventions,
                                      const NumberFormat& format, const Tolerance& tolerance,
                                      Monitor* monitor = nullptr);

/// The largest speed that the motion gives a point of either body, rounded up by 2^-40 of itself.
/// A half-space counts as having the points of the other body. A core that is curved counts as O.
mpq_class largest_speed(const Body& a, const Body& b, const Motion& motion);

}  // namespace fathom::judging
