// SPDX-License-Identifier: GPL-3.0-or-later
// What all pictures share.
#pragma once

#include <string>
#include <string_view>

namespace fathom::plot {

/// The colours, as variables of CSS: light, dark, on paper.
std::string_view colours();

/// The text with what XML would read escaped.
std::string markup(std::string_view text);

}  // namespace fathom::plot
