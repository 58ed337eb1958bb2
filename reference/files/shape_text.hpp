// SPDX-License-Identifier: GPL-3.0-or-later
// A shape in one word of the command line.                                                          [docs/command_line.md]
#pragma once

#include <string>

#include "fathom/files.hpp"
#include "fathom/numbers.hpp"

namespace fathom::files {

/// Returns whether the word stands for a shape and not for a file: it begins with the name of a shape and a colon, "capsule:r=0.1,h=0.5",
/// or with another word of small letters and a colon, and there are fields behind: `parse_shape` then says which shapes there are.
bool is_shape_text(const std::string& word);

/// Reads NAME:FIELD=VALUE,... with the fields of JSON, `r` for radius and `h` for half_length. Three numbers are joined by colons:
/// box:half=1:2:3. `at` moves the shape, `quaternion` turns it before (w:x:y:z), `axis` is x, y or z. Hulls, triangles and sums have no
/// such form. Throws InputError with a sentence on the first fault. `decimals` says what a decimal stands for.
Body parse_shape(const std::string& word, Decimals decimals);

}  // namespace fathom::files
