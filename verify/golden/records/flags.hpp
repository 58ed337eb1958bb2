// SPDX-License-Identifier: GPL-3.0-or-later
// Flags: words for what is special about a record of polytopes. NOTES.md says what each means; all are decided exactly.
#pragma once

#include <string_view>
#include <vector>

#include "verify/golden/records/facts.hpp"

namespace fathom::golden {

/// Returns all flags, in the order in which a record lists them.
std::vector<std::string_view> flag_names();

/// Returns the flags that hold. Everything in `truth` but the flags must be set.
std::vector<std::string_view> flags_of(const HullPair& hulls, const HullStatement& truth);

}  // namespace fathom::golden
