// SPDX-License-Identifier: GPL-3.0-or-later
// What a static picture shows at most; it says what it leaves out.
#pragma once

#include <cstddef>

namespace fathom::atlas {

inline constexpr std::size_t most_arcs = 6000, most_walls = 400, most_nodes = 250, most_optima = 200;

}  // namespace fathom::atlas
