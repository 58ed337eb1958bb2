// SPDX-License-Identifier: GPL-3.0-or-later
// Input   two bodies and an answer.
// Output  its proof as exact text: an inner polytope and a supporting direction.
//                                                                           [proofs/certificate.md]
#pragma once

#include <span>

#include "fathom/certificate.hpp"
#include "kernels/report.hpp"

namespace fathom::certificate {

/// Checks the proof by the definitions, in rationals and over all pairs: the naive twin of the
/// checkers.
[[nodiscard]] kernels::Report validate(const Certificate& certificate);

/// The same for shapes, and all optimal directions of cores that touch by the rules of the format.
/// Throws std::invalid_argument if a shape is none.
[[nodiscard]] kernels::Report validate(const ShapeCertificate& certificate);

/// Of bodies that touch: differences b - a that leave no room for optimal directions other than
/// those of the cone. Each difference is taken from faces of the bodies: O((m + n) r) for r rays.
ConeProof prove_cone(std::span<const Point> a, std::span<const Point> b, const OptimalCone& cone);

/// Checks the cone by the rules of the format, in rationals.
[[nodiscard]] kernels::Report validate(const ConeProof& proof, std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::certificate
