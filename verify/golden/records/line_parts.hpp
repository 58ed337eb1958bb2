// SPDX-License-Identifier: GPL-3.0-or-later
// What the lines of all kinds of records have in common.
#pragma once

#include <string_view>

#include "verify/golden/records/json_text.hpp"
#include "verify/golden/records/recipe.hpp"
#include "verify/golden/records/rounded.hpp"

namespace fathom::golden {

/// "f64": {"rn": .., "rd": .., "ru": ..}, "f32": {..}, as members of the object that is open.
void write_modes(JsonText& out, const Rounded& value);

/// The same of a vector, as a member that is an object.
void write_rounded(JsonText& out, std::string_view key, const RoundedVector& vector);

/// "direction" and "unit".
void write_direction(JsonText& out, const Vector& n, const RoundedVector& unit);

/// The members of "source".
void write_source(JsonText& out, const Recipe& recipe, Form form);

/// "formats".
void write_formats(JsonText& out, bool in_binary64, bool in_binary32);

}  // namespace fathom::golden
