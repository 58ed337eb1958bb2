// SPDX-License-Identifier: GPL-3.0-or-later
// The naive twin of second_nearest_squared.
#pragma once

#include "fathom/depth.hpp"

namespace fathom::depth {

/// Looks at all facets of the hull of all vertex differences. Throws std::invalid_argument unless the bodies penetrate.
std::optional<mpq_class> second_nearest_squared_naive(std::span<const Point> a, std::span<const Point> b);

}  // namespace fathom::depth
