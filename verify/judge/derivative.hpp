// SPDX-License-Identifier: GPL-3.0-or-later
// A claimed derivative of the signed depth, judged: the exact one-sided rate at which the depth
// grows as two bodies begin to move, and what a wrong claim is instead.
//                                           [VERDICTS.md, "wrong-derivative"; proofs/patch.md]
#pragma once

#include <gmpxx.h>

#include "fathom/answer.hpp"
#include "fathom/body.hpp"
#include "fathom/judge.hpp"
#include "fathom/motion.hpp"

namespace fathom::judging {

/// Judges the derivative that the reply claims about these bodies, whose answer is known: wrong by
/// more than the tolerance times the largest speed of a point is wrong. The rest of the reply is
/// looked at to say what a wrong claim is instead. Throws Interrupted.
DerivativeJudgement judged_derivative(const Body& a, const Body& b, const Answer& answer, const Motion& motion,
                                      const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                                      const Tolerance& tolerance, Monitor* monitor = nullptr);

/// The largest speed that the motion gives a point of either body, rounded up by 2^-40 of itself.
/// A half-space counts as having the points of the other body. A core that is curved counts as O.
mpq_class largest_speed(const Body& a, const Body& b, const Motion& motion);

}  // namespace fathom::judging
