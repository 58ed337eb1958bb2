// SPDX-License-Identifier: GPL-3.0-or-later
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
