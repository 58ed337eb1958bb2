// SPDX-License-Identifier: Apache-2.0
// For programs that write certificates: whether checkers will read one, before its proof matters.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "limits.hpp"

namespace fathom_check {

/// Returns why every checker finds the certificate malformed that `text` begins with: it does not
/// follow the grammar, or exceeds a limit, which the phrase names. Returns an empty text if it is
/// well-formed; its proof is not checked. Throws std::bad_alloc.
[[nodiscard]] std::string unreadable(std::string_view text, const Limits& limits = {});

/// A certificate that every checker would find malformed; whoever gets this writes none.
struct Unreadable : std::length_error {
  using std::length_error::length_error;
};

/// Throws Unreadable, with the reason, unless `unreadable` returns an empty text. Code that gives
/// certificates to users calls this first.
void require_readable(std::string_view certificate, const Limits& limits = {});

}  // namespace fathom_check
