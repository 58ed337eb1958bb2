// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a script or a style in a Content-Security-Policy.
#pragma once

#include <string>
#include <string_view>

namespace fathom::page {

/// "sha256-..." with the digest of the text in base 64, as CSP level 2 has it.
std::string source_hash(std::string_view text);

}  // namespace fathom::page
