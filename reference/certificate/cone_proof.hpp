// SPDX-License-Identifier: GPL-3.0-or-later
// Input   bodies that touch, and the cone of their optimal directions.
// Output  differences b - a that leave no room for other directions.                                   [verify/check/FORMAT.md, section 4]
#pragma once

#include <span>

#include "fathom/certificate.hpp"
#include "kernels/report.hpp"

namespace fathom::certificate {

/// Each difference is taken from faces of the bodies: O((m + n) r) for r rays.
ConeProof prove_cone(std::span<const Point> a, std::span<const Point> b, const OptimalCone& cone);

/// Checks the cone by the rules of the format, in rationals.
[[nodiscard]] kernels::Report validate(const ConeProof& proof, std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::certificate
