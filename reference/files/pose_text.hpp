// SPDX-License-Identifier: GPL-3.0-or-later
// A pose as people write it, in one argument or in one string.                                        [docs/command_line.md]
#pragma once

#include <string>
#include <string_view>

#include "fathom/numbers.hpp"
#include "reference/files/pose.hpp"

namespace fathom::files {

/// Reads one of
///   12 or 16 numbers, row by row: between them commas, white space, semicolons, brackets; quotes around one make it exact, as in JSON
///   xyz=X,Y,Z and one of quat=W,X,Y,Z xyzw=X,Y,Z,W rpy=ROLL,PITCH,YAWdeg (or rad), in any order, one of both may be missing
/// Decimals mean what `decimals` says; integers, p/q and hexadecimal floats are exact. Returns a sentence in `fault` if it is neither.
GivenPose parse_pose(std::string_view text, Decimals decimals, std::string& fault);

/// The same of an argument; "@FILE" stands for what is in that file. Throws InputError that names `option`, or the file.
GivenPose read_pose(const std::string& argument, const std::string& option, Decimals decimals);

}  // namespace fathom::files
