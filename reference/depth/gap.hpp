// SPDX-License-Identifier: GPL-3.0-or-later
// How clear an answer is: the facet of P that comes next after the nearest ones.
// Input   two point sets that penetrate, and their depth.
// Output  the squared distance from O of the next nearest facet plane of P. P is never built.                          [proofs/gap.md]
#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>

#include "kernels/vector.hpp"
#include "reference/depth/depth.hpp"

namespace fathom {

/// The least squared distance from O of a facet plane of P that is larger than depth.squared; nothing if all facets of P tie. Exact, for
/// bodies of any rank. `depth` is the answer for the two bodies by any method. Throws std::invalid_argument unless they penetrate.
std::optional<mpq_class> second_nearest_squared(std::span<const Point> a, std::span<const Point> b, const Depth& depth);

/// The naive twin: all facets of the hull of all vertex differences.
std::optional<mpq_class> second_nearest_squared_naive(std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom
