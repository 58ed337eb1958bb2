// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and an answer.
// Output  its proof as exact text: an inner polytope and a supporting direction.                                [proofs/certificate.md]
#pragma once

#include "fathom/certificate.hpp"
#include "kernels/report.hpp"

namespace fathom::certificate {

/// Checks the proof by the definitions, in rationals and over all pairs: the naive twin of the checkers.
[[nodiscard]] kernels::Report validate(const Certificate& certificate);

}  // namespace fathom::certificate
