// SPDX-License-Identifier: GPL-3.0-or-later
// A note for users whose points are not all extreme, as those of a mesh that is not convex: answers are about the hull. It is the same
// with every method, and needs no hull where all points are seen to be extreme.
#pragma once

#include <optional>
#include <string>

#include "cli/io/progress.hpp"
#include "fathom/files.hpp"

namespace fathom::cli {

/// "A: 3 of 11 points are not extreme; the convex hull is taken", for each body of which that is true; nullopt if of none. Repeated points
/// may be extreme.
std::optional<std::string> hull_note(const Case& input, bool one_body);

/// Returns whether hull_note may have a note, without computing a hull.
bool may_have_inner_points(const Case& input, bool one_body);

/// Prints the note on standard error.
void tell_of_hulls(const Case& input, bool one_body, Progress& progress);

}  // namespace fathom::cli
