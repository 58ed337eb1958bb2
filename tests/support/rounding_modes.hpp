// SPDX-License-Identifier: GPL-3.0-or-later
// The rounding modes, for tests of what holds in each of them.
#pragma once

#include <cfenv>

namespace fathom::testing {

inline constexpr int rounding_modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

/// Restores round-to-nearest.
struct RoundingMode {
  explicit RoundingMode(int mode) { std::fesetround(mode); }
  ~RoundingMode() { std::fesetround(FE_TONEAREST); }
};

}  // namespace fathom::testing
