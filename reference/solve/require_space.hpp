// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "fathom/body.hpp"

namespace fathom::solve {

/// Throws std::invalid_argument if a body is of the plane, and says that `what` takes none.
inline void require_space(const Body& a, const Body& b, std::string_view what) {
  if (a.dimension == 2 || b.dimension == 2)
    throw std::invalid_argument(std::string(what) + " takes bodies of space, found a body of the plane");
}

}  // namespace fathom::solve
