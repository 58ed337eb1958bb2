// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and an answer.
// Output  its proof as exact text: an inner polytope and a supporting direction.                                [proofs/certificate.md]
#pragma once

#include "fathom/certificate.hpp"
#include "kernels/report.hpp"

namespace fathom::certificate {

/// Checks the proof by the definitions, in rationals and over all pairs: the naive twin of the checkers.
[[nodiscard]] kernels::Report validate(const Certificate& certificate);

/// The same for shapes, and all optimal directions of cores that touch by the rules of the format. Throws std::invalid_argument if a shape
/// is none.
[[nodiscard]] kernels::Report validate(const ShapeCertificate& certificate);

}  // namespace fathom::certificate
