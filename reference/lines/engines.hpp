// SPDX-License-Identifier: GPL-3.0-or-later
// The engines that find closest lines, and their sizes.
#pragma once

#include <cstdint>

#include "fathom/depth.hpp"

namespace fathom::lines {

/// How finely the cutting engine cuts. Only the work depends on it.
struct CuttingSize {
  std::uint64_t r = 4;        ///< the conflict list of a cell holds at most a share 1/r of the lines
  std::uint64_t few = 16;     ///< cells with at most this many lines are not refined
  std::uint64_t base = 1024;  ///< blocks of at most this many pairs are scanned
  /// What the block tests of a grid may cost beyond an eighth of its crossings before the rest of it is scanned, in pairs scanned.
  std::uint64_t allowance = std::uint64_t{1} << 20;
};

/// The same for the sampled cutting; its cells are not refined below max(8, n / r^3) of n lines.
struct SampledSize {
  std::uint64_t r = 8;
  std::uint64_t base = 2048;
};

}  // namespace fathom::lines
