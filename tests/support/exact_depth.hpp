// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fathom/depth.hpp"

namespace fathom::testing {

/// The answer of the exact method, which every other is compared with.
inline Depth exact_depth(std::span<const Point> a, std::span<const Point> b, Options options = {}) {
  options.method = Method::exact;
  return penetration_depth(a, b, options);
}

}  // namespace fathom::testing
