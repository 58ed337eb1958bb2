// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as text that XML, HTML and terminals take. Ids, details and settings come from others and may hold anything.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fathom::picture {

/// As character data or as a quoted attribute value of XML 1.0 or HTML, in UTF-8. Tabs and line ends become character references;
/// what neither format may hold, and bytes that are not UTF-8, are shown as "\x1b".
std::string markup(std::string_view text);

/// Printable ASCII; other bytes as "\x1b". At most `width` >= 3 characters: what is longer ends in "...".
std::string ascii(std::string_view text, std::size_t width = static_cast<std::size_t>(-1));

/// The text with each absolute path in it cut to its last part: pages and pictures are shown to others, whom folders do not concern. A path
/// begins with a slash where a word begins, and ends at a space, a quotation mark, a comma, a semicolon or a parenthesis.
std::string without_folders(std::string_view text);

}  // namespace fathom::picture
