// SPDX-License-Identifier: GPL-3.0-or-later
// Short integers and decimals, read at the speed of the machine: what nearly every token of a large mesh is.
#pragma once

#include <gmpxx.h>

#include <string_view>

#include "kernels/number/parse.hpp"

namespace fathom {

/// Sets `value` to what parse_number(token, decimals) would yield and returns true; or returns false and leaves the token to it.
/// Never differs from parse_number, which is its naive twin; decimals only in binary64 mode while rounding is to nearest.
bool quick_number(std::string_view token, Decimals decimals, mpq_class& value);

}  // namespace fathom
