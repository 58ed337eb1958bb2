// SPDX-License-Identifier: GPL-3.0-or-later
// A text with named gaps, filled.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace fathom::page {

/// Returns the text with each {{name}} replaced by the value of that name, which is put in as it is: a gap in a value is none. Throws
/// std::logic_error if a name has no value.
std::string filled(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

}  // namespace fathom::page
