// SPDX-License-Identifier: GPL-3.0-or-later
// Untrusted bytes in messages.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fathom::kernels {

/// Returns `text` in single quotes for a message: cut to a readable length, bytes outside printable ASCII as \xNN; "nothing" if it is
/// empty.
std::string shown(std::string_view text);

/// Returns `text` with the bytes outside printable ASCII as \xNN, cut after `limit` bytes.
std::string printable(std::string_view text, std::size_t limit);

}  // namespace fathom::kernels
