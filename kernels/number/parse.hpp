// SPDX-License-Identifier: GPL-3.0-or-later
// A fast path for short integers and decimals, which are nearly all tokens of a large mesh.
#pragma once

#include <optional>
#include <string_view>

#include "fathom/numbers.hpp"

namespace fathom::kernels {

/// Returns the value of parse_number(token, decimals), its naive twin, in binary64; or nullopt, and
/// parse_number has to read the token. Reads decimals only in binary64 mode and while rounding is
/// to nearest.
std::optional<double> quick_number(std::string_view token, Decimals decimals);

}  // namespace fathom::kernels
