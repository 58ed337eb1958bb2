// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in binary64: a fast path for short integers and decimals, which are nearly all tokens of
// a large mesh, and decimals of any length, rounded.
#pragma once

#include <optional>
#include <string_view>

#include "fathom/numbers.hpp"

namespace fathom::kernels {

constexpr bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns the value of parse_number(token, decimals), its naive twin, in binary64; or nullopt, and
/// parse_number has to read the token. Reads decimals only in binary64 mode and while rounding is
/// to nearest.
std::optional<double> quick_number(std::string_view token, Decimals decimals);

/// The nearest binary64 of a decimal of any length, as JSON writes numbers: infinite if it is too
/// large for one, 0 if it is too small.
double nearest_binary64(std::string_view decimal);

}  // namespace fathom::kernels
