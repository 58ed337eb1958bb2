// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace fathom {

/// How the closest lines of a canonical pair are found. All three give the same answer.
enum class ClosestLines : std::uint8_t {
  cutting,  ///< cells along the grid's order, conflict lists, block tests: cutting.hpp
  sampled,  ///< a random sample guides the cells, as in AGHRS: sampled.hpp
  naive,    ///< every pair, through a double filter
};

}  // namespace fathom
