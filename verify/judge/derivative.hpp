// SPDX-License-Identifier: GPL-3.0-or-later
// Judges a claimed derivative of the signed depth: compares it with the exact one-sided rate at
// which the depth grows as two bodies begin to move, and finds which other rate a wrong claim
// equals.
//                                           [VERDICTS.md, "wrong-derivative"; proofs/patch.md]
#pragma once

#include <gmpxx.h>

#include "fathom/answer.hpp"
#include "fathom/body.hpp"
#include "fathom/judge.hpp"
#include "fathom/motion.hpp"

namespace fathom::judging {

/// Judges the derivative that the reply claims about these bodies, whose answer is known. A
/// difference of more than the tolerance times the largest speed of a point is wrong. Other fields
/// of the reply serve to find which other rate a wrong claim equals. Throws Interrupted.
DerivativeJudgement judged_derivative(const Body& a, const Body& b, const Answer& answer, const Motion& motion,
                                      const Reply& reply, const Conventions& conventions, const NumberFormat& format,
                                      const Tolerance& tolerance, Monitor* monitor = nullptr);

/// Returns the largest speed that the motion gives a point of either body, rounded up by 2^-40 of
/// itself. A half-space has the points of the other body. A curved core counts as O.
mpq_class largest_speed(const Body& a, const Body& b, const Motion& motion);

}  // namespace fathom::judging
