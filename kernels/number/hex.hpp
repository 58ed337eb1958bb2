// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fathom::kernels {

/// Appends hex_text(value).
void append_hex(double value, std::string& text);

}  // namespace fathom::kernels
