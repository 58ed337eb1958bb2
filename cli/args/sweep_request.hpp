// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for of study --sweep.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fathom/depth.hpp"

namespace fathom::cli {

/// The engines of the closest lines, in the order of ClosestLines.
inline constexpr std::array<std::string_view, 3> engine_names{"cutting", "sampled", "naive"};

struct SweepRequest {
  std::string family;                 ///< empty: no sweep
  std::vector<unsigned> sizes;        ///< ascending
  std::vector<ClosestLines> engines;  ///< side by side; empty: the usual one
};

}  // namespace fathom::cli
