// SPDX-License-Identifier: GPL-3.0-or-later
// A pose as the user types it: three rows of four numbers.
#pragma once

#include <string>

#include "fathom/numbers.hpp"
#include "reference/files/pose.hpp"

namespace fathom::cli {

/// "r11 r12 r13 t1; r21 r22 r23 t2; r31 r32 r33 t3", where decimals mean what `decimals` says and integers, p/q and hexadecimal floats
/// are exact; or a JSON array of three arrays of four, as in a case: a number means the nearest binary64, a string is exact.
/// Throws an InputError that names `option`.
files::Pose parse_pose(const std::string& text, const std::string& option, Decimals decimals);

}  // namespace fathom::cli
