// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which people count files: piece_2 before piece_10.
#pragma once

#include <string_view>

namespace fathom::files {

/// Whether `a` comes before `b`: runs of digits are compared as numbers of any length, all else byte by byte. What differs only in
/// leading zeros is in the order of bytes, so no two texts are equal.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace fathom::files
