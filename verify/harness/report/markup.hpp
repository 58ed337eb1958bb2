// SPDX-License-Identifier: GPL-3.0-or-later
// Ids as reports show them, and the ways to write what others sent as text of a document.
#pragma once

#include <string>
#include <string_view>

#include "view/picture/markup.hpp"

namespace fathom::harness {

using picture::ascii;
using picture::markup;

/// The id, and the symmetry if there is one: "id ~swap".
std::string shown_id(std::string_view id, std::string_view variant);

}  // namespace fathom::harness
