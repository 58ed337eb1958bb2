// SPDX-License-Identifier: GPL-3.0-or-later
// What is remarkable about a record, as words. NOTES.md says what each means; every one is decided exactly.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "verify/golden/records/record_facts.hpp"

namespace fathom::golden {

/// All words, in the order in which a record lists them.
std::vector<std::string_view> flag_names();

/// Those that hold. Everything in `facts` but the flags must be set.
std::vector<std::string_view> flags_of(const Facts& facts);

}  // namespace fathom::golden
