// SPDX-License-Identifier: GPL-3.0-or-later
// What the user asked for of depth --along.
#pragma once

#include <cstdint>
#include <optional>

#include "fathom/point.hpp"

namespace fathom::cli {

struct AlongRequest {
  std::optional<Point> translation;  ///< set if the depth along a path is asked for: A is moved by parts of it, and by all of it in the end
  std::uint32_t steps = 32;
};

}  // namespace fathom::cli
